#pragma once
// Counts requests to memory where the machine code makes them: the lanes are those that the replay has there,
// the addresses those of the trace.

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/sass/memory_sites.hpp"
#include "profiler/sass/ptx_decisions.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::sass {

// Sums over warps, by stream of the memory sites.
struct RequestCounters {
  explicit RequestCounters(std::size_t n_streams)
      : requests(n_streams), unmatched(n_streams), borrowed(n_streams) {}
  void add(const RequestCounters& other);

  std::vector<MemoryCounters> requests;
  // Accesses of lanes that the code makes and the trace does not, or the other way around: the requests of
  // such a stream are not what the machine makes.
  std::vector<std::uint64_t> unmatched;
  std::vector<std::uint64_t> borrowed;  // accesses that an instruction of another stream made
};

// One a thread, for the lanes of one warp at a time. All outlive it.
class RequestCounter {
 public:
  RequestCounter(const MemorySites& sites, const PtxDecisions& decisions, RequestCounters& counters);

  // Takes in the addresses of the lanes; nothing is counted where their traces have none.
  void begin_warp(std::span<const LaneTrace> lanes);
  // The lanes come to a block of the code. `ahead`, of each: how many entries of its trace it has left behind
  // when it makes its next choice; an access under a predicate that comes later is not of this block.
  void count(std::uint32_t block, std::uint32_t lanes, const std::array<std::uint32_t, 32>& ahead);
  bool needs_ahead(std::uint32_t block) const { return has_addresses_ && needs_ahead_[block]; }
  bool ever_needs_ahead() const;
  void end_warp();

 private:
  struct Noted {            // small: a warp's are to stay in the nearest cache
    std::uint32_t address;  // where the addresses of a block begin among the lane's
    std::uint32_t entry;    // of the trace; no_entry: behind the last one
  };
  static constexpr std::uint32_t no_entry = 0xFFFFFFFF;
  struct Push {  // what a run of blocks adds to a queue
    std::uint32_t queue, offset;
  };
  struct Run {
    std::uint32_t first_push = 0, last_push = 0;
    std::uint32_t adds = 0;  // 1 if there are pushes
    std::uint32_t n_addresses = 0;
  };
  // The lane's next access of a stream; null if there is none.
  const Noted* next(std::uint32_t stream, std::uint32_t lane) const {
    const Noted* const noted = next_[stream * 32 + lane];
    return noted->entry == no_entry ? nullptr : noted;
  }
  void add_lane(std::uint32_t lane, const LaneTrace& trace);
  void take_next(std::uint32_t stream, std::uint32_t lanes, std::array<std::uint64_t, 32>& addresses,
                 std::size_t& n);
  std::uint64_t take(const MemorySite& site, std::uint32_t lane, std::uint32_t ahead);

  const MemorySites& sites_;
  RequestCounters& counters_;
  std::vector<bool> needs_ahead_;                         // [blocks of the code]
  std::vector<Run> runs_;                                 // [blocks of the PTX]: of a run from there
  std::vector<Push> pushes_;                              // of the runs, one after another
  std::array<const std::uint64_t*, 32> traced_{};         // the lanes' addresses
  std::vector<std::vector<Noted>> queues_;                // [queues][32]
  std::vector<Noted> adding_ = std::vector<Noted>(1024);  // of the lane: entries whose run adds anything
  bool has_addresses_ = false;
  std::vector<const Noted*> next_;  // [streams][32]: of the queue
};

}  // namespace warpgrain::profiler::sass
