#pragma once
// The memory that the work-groups of a launch share: its buffers and the module's variables.

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "profiler/safety/memory_region.hpp"
#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

class LaunchMemory {
 public:
  LaunchMemory(const TranslatedKernel& kernel, const LaunchShape& shape,
               std::span<const KernelArgument> arguments, bool concurrent);

  // Of a parameter's buffer or a variable of the module; an empty one for other objects.
  const MemoryRegion& region_of(std::uint32_t object) const { return regions_[object]; }
  // That holds the address; null when none does.
  const MemoryRegion* find(std::uint64_t address) const;

 private:
  void add_regions(const TranslatedKernel& kernel, std::span<const KernelArgument> arguments);
  void group_overlapping();
  void prepare(MemoryState& state, const TranslatedKernel& kernel, bool concurrent) const;

  std::vector<MemoryRegion> regions_;                 // [objects]
  std::vector<const MemoryRegion*> by_address_;       // those that are anywhere, ascending
  std::vector<std::unique_ptr<MemoryState>> states_;  // ascending, apart from each other
};

}  // namespace warpgrain::profiler
