#pragma once
// What must hold of a random kernel: the simulator and the reference leave the same bytes, and the simulator
// counts what the interpreter counts.

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "tests/profiler/oracle/random_kernel.hpp"

namespace warpgrain::oracle {

// Runs the kernel of a program elsewhere and leaves the buffers as it leaves them.
using ReferenceRun = std::function<void(const std::string& source, const std::string& kernel,
                                        const profiler::LaunchShape& shape,
                                        const std::vector<profiler::KernelArgument>& arguments)>;

struct Finding {
  const RandomKernel* kernel = nullptr;
  std::vector<std::string> lines;
};

// Compiles the kernels as one program and checks each of them. A kernel that throws is a finding, too.
std::vector<Finding> check_kernels(std::span<const RandomKernel> kernels, const ReferenceRun& reference);

// The build options for PoCL as the reference. Optimised, PoCL 3.1 gets loops around barriers wrong now and
// then (the kernel of seed 14 was one).
inline constexpr const char* reference_options = "-cl-std=CL1.2 -cl-opt-disable";

// Seed, differences, source.
std::string report(const Finding& finding);

}  // namespace warpgrain::oracle
