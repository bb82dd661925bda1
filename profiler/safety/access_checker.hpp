#pragma once
// The checks of the accesses of one runner's lanes: what translated code calls where its short comparison
// does not hold.

#include <array>
#include <cstdint>
#include <vector>

#include "profiler/lane_context.hpp"
#include "profiler/safety/launch_monitor.hpp"

namespace warpgrain::profiler {

class AccessChecker {
 public:
  // `shared_offsets` as launch_check gives them.
  AccessChecker(LaunchMonitor& monitor, std::span<const std::byte> parameters,
                std::span<const std::byte> shared, std::span<const std::size_t> shared_offsets);
  AccessChecker(const AccessChecker&) = delete;
  AccessChecker& operator=(const AccessChecker&) = delete;

  void place(LaneContext& lane);  // makes it call this
  void begin_group(std::uint64_t number);
  void lanes_met(std::span<const std::size_t> lanes, bool of_warp);

 private:
  struct Access {
    const AccessSite& site;
    std::uint32_t index;
    std::uint64_t address;
    LaneContext& lane;
  };

  static std::byte* look_closer(LaneContext* lane, std::uint32_t site, std::uint64_t address);
  static std::uint64_t readable(const LaneContext* lane, std::uint64_t address);
  std::byte* look(const Access& access);
  void look_at_history(const Access& access, const MemoryRegion& region);
  void look_at_initialization(const Access& access, const MemoryRegion& region);

  void add_shared_regions(std::span<const std::byte> shared, std::span<const std::size_t> shared_offsets);
  void bind(std::uint32_t site, const MemoryRegion& region);
  const MemoryRegion* region_of(const Access& access);  // null: none
  const MemoryRegion* find(const LaneContext& lane, std::uint64_t address);
  MemoryRegion local_region(const LaneContext& lane, const MemoryObject* object) const;
  bool may_go(const AccessSite& site, const MemoryRegion& region) const;

  std::byte* refuse(const Access& access, const MemoryRegion* region);
  std::byte* refuse(DiagnosticKind kind, const Access& access, const MemoryRegion* region);
  void note(DiagnosticKind kind, const Access& access, const MemoryRegion* region,
            const RaceFound* race = nullptr);
  std::uint64_t item_of(const LaneContext& lane) const { return first_item_ + lane.linear_tid; }
  Visit visit_of(const Access& access) const;

  LaunchMonitor& monitor_;
  const TranslatedKernel& kernel_;
  std::vector<SiteBounds> bounds_;             // [sites]
  std::vector<const MemoryRegion*> regions_;   // [sites]; null where the next access finds it
  std::vector<MemoryRegion> shared_;           // of objects in shared memory, by address
  std::vector<std::uint32_t> shared_objects_;  // the object of each
  MemoryState shared_state_;
  MemoryRegion parameters_;
  MemoryRegion local_;  // of the lane at hand
  std::uint64_t first_item_ = 0;
  GroupClock clock_;
  // Where fences order work-groups: who has used an atomic, and is taken for ordered from there on.
  std::vector<bool> lane_synchronized_;
  bool group_synchronized_ = false;
  alignas(16) std::array<std::byte, 32> nowhere_{};  // for what must not go where it would
};

}  // namespace warpgrain::profiler
