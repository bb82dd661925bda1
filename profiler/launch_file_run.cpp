#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string read_program(const LaunchFile& file) {
  std::ifstream in(file.program, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    throw_input_error(fmt::format("{}: program '{}'", file.path.string(), file.program.string()),
                      "cannot be read", "OpenCL C, or PTX in a .ptx file");
  return text.str();
}

}  // namespace

LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out) {
  LaunchFileResult result;
  LaunchProfile& profile = result.profile;
  profile.source = read_program(file);
  profile.source_name = file.program.string();

  const Clock::time_point compile_begin = Clock::now();
  std::vector<ParameterDeclaration> declared;
  if (file.program.extension() == ".ptx") {
    profile.ptx = profile.source;
  } else {
    CompiledPtx compiled = compile_opencl(profile.source, profile.source_name, build_options);
    profile.ptx = std::move(compiled.ptx);
    profile.compiler = std::move(compiled.compiler);
    profile.compile_command = std::move(compiled.command);
  }
  const TraceMode mode = options.addresses ? TraceMode::blocks_and_addresses : TraceMode::blocks;
  const auto executable = Executable::compile(profile.ptx, file.kernel, mode, profile.source_name);
  if (!profile.compiler.empty())
    declared = declared_parameters(profile.source, profile.source_name, build_options, file.kernel);
  profile.compile_seconds = seconds_since(compile_begin);

  std::vector<BoundArgument> bound = bind_arguments(file, executable->parameters(), declared);
  std::vector<KernelArgument> arguments;
  for (const BoundArgument& argument : bound) arguments.push_back(argument.argument);
  ProfileOptions named_options = options;
  named_options.source_name = profile.source_name;
  named_options.printed = &out;
  const Clock::time_point run_begin = Clock::now();
  profile.counters = profile_launch(*executable, file.shape, arguments, profile.source, named_options);
  profile.run_seconds = seconds_since(run_begin);

  dump_arguments(file, bound, out);
  for (BoundArgument& argument : bound) result.buffers.push_back(std::move(argument.buffer));
  return result;
}

}  // namespace warpgrain::profiler
