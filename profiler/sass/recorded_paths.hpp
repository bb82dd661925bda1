#pragma once
// The paths of divisions that a lane's trace holds.

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "profiler/division_path.hpp"
#include "profiler/sass/ptx_decisions.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_record = 0xFFFFFFFF;

// One a thread.
class RecordedPaths {
 public:
  explicit RecordedPaths(const PtxDecisions& decisions);

  // The number of the instruction at a line of the PTX, no_record where it records nothing.
  std::uint32_t record_of(std::uint32_t line) const;
  // Takes in the trace of a lane.
  void read(const LaneTrace& trace);
  // The path of the lane's next execution of that instruction; in_line where the trace has no addresses.
  DivisionPath next(std::uint32_t record);

 private:
  struct Recorded {
    std::uint32_t record, offset;  // among the addresses of a run
  };
  struct Run {
    std::vector<Recorded> recorded;
    std::uint32_t n_addresses = 0;
  };
  std::unordered_map<std::uint32_t, std::uint32_t> by_line_;
  std::vector<Run> runs_;                         // [blocks of the PTX]: of a run from there
  std::vector<std::vector<DivisionPath>> paths_;  // [records]: of the lane, in order
  std::vector<std::size_t> taken_;
};

}  // namespace warpgrain::profiler::sass
