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

// The same for kernels in PTX, which no reference runs: the simulator counts what the interpreter counts and
// leaves the same bytes.
std::vector<Finding> check_ptx_kernels(std::span<const RandomKernel> kernels);

// The build options for PoCL as the reference. With optimisation, PoCL 3.1 gets some kernels with barriers in
// loops wrong; without, it also compiles twice as fast.
inline constexpr const char* reference_options = "-cl-std=CL1.2 -cl-opt-disable";

// Seed, differences, source.
std::string report(const Finding& finding);

}  // namespace warpgrain::oracle
