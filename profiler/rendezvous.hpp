#pragma once
// What a lane asks of others when it stops for them: translated code fills it in before the lane waits and
// reads the answer behind. The layout is part of the code that the translator emits.

#include <cstdint>

namespace warpgrain::profiler {

enum class Meeting : std::uint32_t {
  // Of the work-group. An arrival counts and does not wait.
  barrier,
  barrier_arrive,
  barrier_popc,
  barrier_and,
  barrier_or,
  // Of the warp.
  warp_barrier,
  shuffle_up,
  shuffle_down,
  shuffle_butterfly,
  shuffle_index,
  vote_all,
  vote_any,
  vote_uniform,
  vote_ballot,
  match_any,
  match_all,
  active_mask,
  elect,
  reduce_add,
  reduce_min_signed,
  reduce_min_unsigned,
  reduce_max_signed,
  reduce_max_unsigned,
  reduce_and,
  reduce_or,
  reduce_xor
};

constexpr bool is_of_warp(Meeting meeting) { return meeting >= Meeting::warp_barrier; }

struct Rendezvous {
  Meeting meeting = Meeting::barrier;
  std::uint32_t block = 0;    // of the graph, where the lane waits
  std::uint32_t members = 0;  // the member mask of a `.sync` form
  // Whether the instruction names its members; else those lanes meet that are there.
  std::uint32_t has_members = 0;
  std::uint32_t index = 0;    // a shuffle's source operand; a barrier's number
  std::uint32_t bound = 0;    // a shuffle's clamp and segment mask; a barrier's thread count, 0: all
  std::uint32_t aligned = 0;  // a barrier whose warps come as one
  std::uint32_t holds = 0;    // the answer's predicate
  std::uint64_t value = 0;    // what the lane brings
  std::uint64_t result = 0;   // what it gets
};

}  // namespace warpgrain::profiler
