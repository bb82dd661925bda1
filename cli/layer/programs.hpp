#pragma once
// The programs that an application has made: their sources and how they were built.

#include <CL/cl_icd.h>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace warpgrain::layer {

// What a kernel was compiled of.
struct ProgramText {
  std::string source = {}, options = {};
  std::filesystem::path folder = {};                              // the application's, where it was built
  std::vector<std::pair<std::string, std::string>> headers = {};  // name and text, of clCompileProgram
  std::string unknown = {};  // why there is no source: "a program made from a binary"; empty: there is

  bool operator==(const ProgramText&) const = default;
};

// Thread safe. Counts references as OpenCL does.
class Programs {
 public:
  void add_source(cl_program program, std::string source);
  void add_unknown(cl_program program, std::string why);
  void retain(cl_program program);
  void release(cl_program program);

  void build(cl_program program, const char* options);
  void compile(cl_program program, const char* options, const std::vector<cl_program>& headers,
               const char** header_names);
  void link(cl_program program, const std::vector<cl_program>& inputs);

  // As it was built last. Never null.
  std::shared_ptr<const ProgramText> text_of(cl_program program) const;

 private:
  struct Program {
    int references = 1;
    std::shared_ptr<const ProgramText> text;
  };
  void add(cl_program program, ProgramText text);
  std::shared_ptr<const ProgramText> find(cl_program program) const;

  mutable std::mutex mutex_;
  std::map<cl_program, Program> programs_;
};

}  // namespace warpgrain::layer
