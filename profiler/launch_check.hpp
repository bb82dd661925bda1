#pragma once
// Launches and arguments against what a kernel declares.

#include <cstddef>
#include <span>
#include <vector>

#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

// Throws InputError for an index space that no device runs or the kernel forbids.
void check_shape(const TranslatedKernel& kernel, const LaunchShape& shape);

// Throws InputError naming the first argument that does not fit its parameter.
void check_arguments(const TranslatedKernel& kernel, std::span<const KernelArgument> arguments);

// Where each argument that is local memory lies, counted from the work-group's shared memory; the last
// element is the size of it all. [arguments + 1]
std::vector<std::size_t> shared_offsets(const TranslatedKernel& kernel,
                                        std::span<const KernelArgument> arguments);

}  // namespace warpgrain::profiler
