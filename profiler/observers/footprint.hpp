#pragma once
// Which memory a launch touches, each piece counted once: by each work-group, and by all of them together.
// Beside the sectors of all requests it says how much is asked for again, which caches may serve.

#include <atomic>
#include <cstdint>
#include <deque>
#include <span>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/trace.hpp"
#include "profiler/what_if_run.hpp"

namespace warpgrain::profiler {

// The sectors of a launch's buffers, marked by any number of threads at once.
class TouchedSectors {
 public:
  explicit TouchedSectors(std::span<const KernelArgument> arguments);

  // The number of the sector that holds the address; no_sector where it lies in no buffer.
  static constexpr std::uint64_t no_sector = ~std::uint64_t{0};
  std::uint64_t sector_of(std::uint64_t address) const;
  void loaded(std::uint64_t sector);
  // `bytes`: a bit for each byte of the sector.
  void stored(std::uint64_t sector, std::uint32_t bytes);
  void updated(std::uint64_t sector);  // by an atomic
  void count(FootprintCounters& counters) const;
  TouchedMemory all() const;

 private:
  struct Buffer {
    std::uint64_t begin, end, first_sector;
  };
  struct Sector {
    std::atomic<std::uint32_t> stored_bytes{0};
    std::atomic<bool> loaded{false}, updated{false};
  };
  std::vector<Buffer> buffers_;  // by address
  std::vector<Sector> sectors_;
};

// Distinct whole numbers, forgotten all at once.
class DistinctNumbers {
 public:
  // Whether it was not there before.
  bool insert(std::uint64_t number);
  void clear();

 private:
  struct Slot {
    std::uint64_t number = 0, round = 0;  // holds a number of that round
  };
  void grow();

  std::vector<Slot> slots_ = std::vector<Slot>(1024);  // a power of two
  std::uint64_t round_ = 1, n_ = 0;
};

// Sees the work-groups that one thread of the program runs.
class FootprintVisitor : public GroupVisitor {
 public:
  FootprintVisitor(const KernelGraph& graph, TouchedSectors& touched) : graph_(&graph), touched_(&touched) {}
  void visit(std::uint64_t group, std::span<const LaneTrace> lanes) override;

  std::uint64_t group_load_sectors = 0, group_store_sectors = 0;

 private:
  void walk(const LaneTrace& lane);
  void load(std::uint64_t address, std::uint32_t bytes);
  void store(std::uint64_t address, std::uint32_t bytes);
  void update(std::uint64_t address, std::uint32_t bytes);

  const KernelGraph* graph_;
  TouchedSectors* touched_;
  DistinctNumbers loaded_, stored_;
};

class LaunchFootprint {
 public:
  // `graph` outlives it.
  LaunchFootprint(const KernelGraph& graph, std::span<const KernelArgument> arguments)
      : graph_(&graph), touched_(arguments) {}
  // Not to be called side by side; belongs to this. Its traces have addresses.
  GroupVisitor& new_visitor() { return visitors_.emplace_back(*graph_, touched_); }
  // When all have seen their work-groups.
  FootprintCounters counters() const;
  TouchedMemory touched() const { return touched_.all(); }

 private:
  const KernelGraph* graph_;
  TouchedSectors touched_;
  std::deque<FootprintVisitor> visitors_;  // which keep their place
};

}  // namespace warpgrain::profiler
