#pragma once
// Launches and arguments against what a kernel declares.

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

// Throws InputError for an index space that no device runs or the kernel forbids.
void check_shape(const TranslatedKernel& kernel, const LaunchShape& shape);

// Throws InputError naming the first argument that does not fit its parameter.
void check_arguments(const TranslatedKernel& kernel, std::span<const KernelArgument> arguments);

// Where local memory begins behind `static_bytes` of shared memory.
std::uint32_t dynamic_shared_offset(std::uint32_t static_bytes);

// Where each argument that is local memory lies, counted from the work-group's shared memory; the last
// element is the size of it all. [arguments + 1]
std::vector<std::size_t> shared_offsets(const TranslatedKernel& kernel,
                                        std::span<const KernelArgument> arguments);

}  // namespace warpgrain::profiler
