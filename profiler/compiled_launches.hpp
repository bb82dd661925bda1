#pragma once
// What launches of the same programs have in common, compiled once.

#include <map>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::profiler {

class CompiledLaunches {
 public:
  // The program's text and its PTX, without counters. A program is known by its file and its options: files
  // must not change while this lives. `build_options` follow the file's own. Throws InputError for what
  // cannot be read or does not compile.
  const LaunchProfile& program(const LaunchFile& file, const std::string& build_options);

  // The parameters of the file's kernel as its source declares them; none for another language than OpenCL C.
  std::vector<ParameterDeclaration> declared(const LaunchFile& file, const std::string& build_options);

  const Executable& kernel(const LaunchFile& file, const std::string& build_options, TraceMode mode,
                           Checks checks);

 private:
  using ProgramKey = std::pair<std::string, std::string>;  // file and all options
  std::map<ProgramKey, LaunchProfile> programs_;
  std::map<ProgramKey, std::string> declarations_;  // bitcode
  std::map<std::tuple<ProgramKey, std::string, TraceMode, Checks>, std::unique_ptr<Executable>> kernels_;
};

}  // namespace warpgrain::profiler
