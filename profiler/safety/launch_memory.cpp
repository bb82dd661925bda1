#include "profiler/safety/launch_memory.hpp"

#include <algorithm>

namespace warpgrain::profiler {
namespace {

// No device loads or stores more at once.
constexpr std::uint32_t largest_access = 16;

// Constant buffers lie in global memory, so that either kind of access may reach either.
bool may_be_global(const AccessSite& site) {
  return site.space == AccessSpace::generic || site.space == AccessSpace::global ||
         site.space == AccessSpace::constant;
}

}  // namespace

LaunchMemory::LaunchMemory(const TranslatedKernel& kernel, const LaunchShape& shape,
                           std::span<const KernelArgument> arguments, bool concurrent) {
  add_regions(kernel, arguments);
  for (const MemoryRegion& region : regions_)
    if (region.begin != 0 && region.size != 0) by_address_.push_back(&region);
  std::sort(by_address_.begin(), by_address_.end(),
            [](const MemoryRegion* a, const MemoryRegion* b) { return a->begin < b->begin; });
  group_overlapping();
  const std::uint64_t groups = shape.group_count()[0] * shape.group_count()[1] * shape.group_count()[2];
  const bool alone = groups * shape.work_group_size() == 1;
  for (const auto& state : states_) {
    if (!alone) prepare(*state, kernel, concurrent);
    bool uninitialized = false;
    for (const MemoryRegion& region : regions_)
      uninitialized |= region.state == state.get() && region.uninitialized;
    if (uninitialized) state->initialized = ZeroPages<std::uint8_t>(state->end - state->begin);
  }
  for (MemoryRegion& region : regions_)
    if (region.state && !region.state->needs_look()) region.state = nullptr;
}

void LaunchMemory::add_regions(const TranslatedKernel& kernel, std::span<const KernelArgument> arguments) {
  for (const MemoryObject& object : kernel.memory.objects) {
    MemoryRegion region;
    region.name = object.name;
    region.writable = !object.read_only;
    region.space = object.read_only ? AccessSpace::constant : AccessSpace::global;
    if (object.kind == MemoryObject::Kind::variable) {
      region.begin = reinterpret_cast<std::uintptr_t>(kernel.variables[object.offset]);
      region.size = region.begin == 0 ? 0 : object.bytes;
    } else if (object.kind == MemoryObject::Kind::parameter &&
               arguments[object.offset].kind == KernelArgument::Kind::buffer) {
      const KernelArgument& argument = arguments[object.offset];
      if (!argument.memory.empty()) region.begin = reinterpret_cast<std::uintptr_t>(argument.memory.data());
      region.size = argument.memory.size();
      if (!argument.name.empty()) region.name = argument.name;
      region.writable &= !argument.read_only;
      region.readable = !argument.write_only;
      region.vector_bytes = std::min(argument.vector_bytes, largest_access);
      region.uninitialized = argument.uninitialized;
    }
    regions_.push_back(std::move(region));
  }
}

// The same memory may be given as several arguments.
void LaunchMemory::group_overlapping() {
  for (const MemoryRegion* region : by_address_) {
    const std::uint64_t begin = region->begin & ~std::uint64_t{largest_access - 1};
    if (states_.empty() || begin >= states_.back()->end) {
      states_.push_back(std::make_unique<MemoryState>());
      states_.back()->begin = begin;
    }
    states_.back()->end = std::max(states_.back()->end, region->begin + region->size);
    regions_[static_cast<std::size_t>(region - regions_.data())].state = states_.back().get();
  }
}

// A history where some access writes and not all are atomics.
void LaunchMemory::prepare(MemoryState& state, const TranslatedKernel& kernel, bool concurrent) const {
  bool written = false, read = false, all_ordered = true;
  std::uint32_t granule = largest_access, vector_bytes = 0;
  for (const MemoryRegion& region : regions_)
    if (region.state == &state) vector_bytes = std::max(vector_bytes, region.vector_bytes);
  for (const AccessSite& site : kernel.memory.sites) {
    const bool touches =
        site.object == AccessSite::any_object ? may_be_global(site) : regions_[site.object].state == &state;
    if (!touches) continue;
    written |= site.kind != AccessKind::load;
    read |= site.kind == AccessKind::load;
    all_ordered &= site.ordered;
    granule = std::min<std::uint32_t>(granule, site.bytes);
  }
  // Where fences order work-groups, atomics show when.
  if (written && (!all_ordered || kernel.memory.has_fence))
    state.history = std::make_unique<AccessHistory>(state.end - state.begin, granule, vector_bytes, read,
                                                    concurrent, false);
}

const MemoryRegion* LaunchMemory::find(std::uint64_t address) const {
  auto found =
      std::upper_bound(by_address_.begin(), by_address_.end(), address,
                       [](std::uint64_t a, const MemoryRegion* region) { return a < region->begin; });
  while (found != by_address_.begin()) {
    const MemoryRegion* region = *--found;
    if (region->holds(address, 1)) return region;
  }
  return nullptr;
}

}  // namespace warpgrain::profiler
