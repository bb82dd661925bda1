#pragma once
// What a kernel's PTX declares of itself: enough to launch it elsewhere.

#include <string>
#include <string_view>
#include <vector>

#include "profiler/launch.hpp"

namespace warpgrain::profiler {

struct KernelSignature {
  std::string symbol;  // its name in the PTX
  // A last one of no bytes stands for shared memory whose size the launch gives (`extern __shared__`).
  std::vector<KernelParameter> parameters;
};

// Throws InputError naming the kernels there are. `where` names the PTX in messages.
KernelSignature kernel_signature(std::string_view ptx, std::string_view kernel, std::string_view where);

}  // namespace warpgrain::profiler
