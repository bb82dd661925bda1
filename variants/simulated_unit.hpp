#pragma once
// A unit of kernels compiled for the simulator. Units are shared: the variants of a sweep have most of their
// kernels in common, and compiling them costs more than running them. Needs the simulator.

#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/kernel_declaration.hpp"
#include "profiler/opencl_frontend.hpp"
#include "variants/kernel_compiler.hpp"
#include "variants/simt_device.hpp"
#include "variants/step_plan.hpp"

namespace warpgrain {

struct SimulatedKernel {
  std::unique_ptr<profiler::Executable> executable;
  std::vector<profiler::ParameterDeclaration> parameters;  // of a checked kernel
  double compile_seconds = 0;
};

class SimulatedUnit {
 public:
  static constexpr const char* name = "kernels";  // in messages and reports

  // The unit of that text and those options, compiled by that compiler if no device has it or had it lately.
  // Throws InputError with the compiler's message.
  static std::shared_ptr<SimulatedUnit> of(const SourceUnit& source, KernelCompiler compiler,
                                           profiler::TraceMode mode, profiler::Checks checks,
                                           Approximations approximations);

  const std::string& text() const { return source_.text; }
  const profiler::CompiledPtx& compiled() const { return compiled_; }
  // Stays where it is. Any thread may ask. Throws InputError that names the kernels there are.
  const SimulatedKernel& kernel(const std::string& kernel_name);

 private:
  SimulatedUnit(const SourceUnit& source, KernelCompiler compiler, profiler::TraceMode mode,
                profiler::Checks checks, Approximations approximations);

  SourceUnit source_;
  KernelCompiler compiler_;
  profiler::TraceMode mode_;
  profiler::Checks checks_;
  Approximations approximations_;
  profiler::CompiledPtx compiled_;
  std::string declarations_;  // bitcode; with checks
  std::mutex mutex_;
  std::map<std::string, SimulatedKernel> kernels_;
};

}  // namespace warpgrain
