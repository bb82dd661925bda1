#pragma once
// Runs a kernel with checks and gives what they found.

#include <string>
#include <string_view>
#include <vector>

#include "profiler/element_type.hpp"
#include "profiler/profile.hpp"
#include "profiler/safety/launch_monitor.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {

inline LaunchCounters run_checked(const Executable& executable, const LaunchShape& shape,
                                  const std::vector<KernelArgument>& arguments, unsigned threads = 1,
                                  std::uint64_t max_instructions = 1'000'000) {
  ProfileOptions options;
  options.threads = threads;
  options.max_instructions = max_instructions;
  return profile_launch(executable, shape, arguments, "", options);
}

// Of kernel `k` of OpenCL C. Arguments get the names and vector sizes of the source.
inline LaunchCounters run_checked(std::string_view source, const LaunchShape& shape,
                                  std::vector<KernelArgument> arguments, unsigned threads = 1,
                                  TraceMode mode = TraceMode::blocks_and_addresses) {
  const auto declared = declared_parameters(source, "kernel.cl", "", "k");
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    arguments[i].name = declared.at(i).name;
    arguments[i].vector_bytes = vector_bytes_of_parameter(declared[i].type);
  }
  const auto executable =
      Executable::compile(compile_opencl(source, "kernel.cl", "").ptx, "k", mode, "kernel.cl", Checks::on);
  return run_checked(*executable, shape, arguments, threads);
}

// The diagnostics without PTX lines, which depend on the compiler.
inline std::vector<std::string> findings(const LaunchCounters& counters) {
  std::vector<std::string> texts;
  for (const Diagnostic& diagnostic : counters.diagnostics) {
    std::string text = diagnostic_text(diagnostic);
    for (std::size_t at; (at = text.find(" (PTX line ")) != std::string::npos;)
      text.erase(at, text.find(')', at) + 1 - at);
    texts.push_back(std::move(text));
  }
  return texts;
}

}  // namespace warpgrain::profiler
