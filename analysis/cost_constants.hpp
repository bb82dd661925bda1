#pragma once
// What the cost model (analysis/cost_model.hpp) needs to know of a machine beside its published peaks, as the
// optional "cost" of "warpgrain.machine/1". Limits are published; the rest is fitted to measured times of
// small kernels that each do one thing (bench/cost/), never to the kernels that are then predicted.

#include <array>
#include <string>
#include <string_view>

namespace warpgrain {

struct MachineValue {
  double value = 0;
  std::string source;  // the document that says so
};

struct CostConstants {
  // What one multiprocessor holds at a time.
  MachineValue warps;         // resident ones
  MachineValue work_groups;   // resident ones
  MachineValue registers;     // 32-bit ones
  MachineValue shared_bytes;  // of shared (local) memory

  MachineValue launch;             // s, of a launch that nothing overlaps, before its first instruction
  MachineValue next_launch;        // s, of a launch that follows another
  MachineValue group_start;        // clocks of a multiprocessor to start a work-group
  MachineValue instruction;        // clocks from an instruction of a warp to the next, with what it waits for
  MachineValue load;               // clocks more that a warp waits for a load from the first cache
  MachineValue far_load;           // clocks more for one from the second cache
  MachineValue line;               // clocks of the first cache for a 128-byte line of a request
  MachineValue far_sector;         // clocks of a multiprocessor for a sector loaded from the second cache
  MachineValue memory_sector;      // clocks more for a sector loaded from memory
  MachineValue store_sector;       // clocks for a sector that a request stores in full
  MachineValue part_store_sector;  // clocks for a sector that a request stores in part
  MachineValue memory_part_sector;  // clocks more for such a one that is not in the second cache
  MachineValue atomic_sector;       // clocks for a sector of an atomic request
  MachineValue cached_bytes;        // how much of what a step touches the second cache keeps to the next use
  MachineValue overlap;             // exponent: 1 adds up what the parts take, more lets them overlap
};

// The values under their keys, in the order of the format; the first `n_limits` are published limits, the
// rest is fitted.
struct CostKey {
  std::string_view key;
  MachineValue CostConstants::*value;
};
inline constexpr std::size_t n_limits = 4;
inline constexpr std::array<CostKey, 19> cost_keys{
    {{"warps", &CostConstants::warps},
     {"work_groups", &CostConstants::work_groups},
     {"registers", &CostConstants::registers},
     {"shared_bytes", &CostConstants::shared_bytes},
     {"launch", &CostConstants::launch},
     {"next_launch", &CostConstants::next_launch},
     {"group_start", &CostConstants::group_start},
     {"instruction", &CostConstants::instruction},
     {"load", &CostConstants::load},
     {"far_load", &CostConstants::far_load},
     {"line", &CostConstants::line},
     {"far_sector", &CostConstants::far_sector},
     {"memory_sector", &CostConstants::memory_sector},
     {"store_sector", &CostConstants::store_sector},
     {"part_store_sector", &CostConstants::part_store_sector},
     {"memory_part_sector", &CostConstants::memory_part_sector},
     {"atomic_sector", &CostConstants::atomic_sector},
     {"cached_bytes", &CostConstants::cached_bytes},
     {"overlap", &CostConstants::overlap}}};

}  // namespace warpgrain
