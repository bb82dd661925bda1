#include "profiler/warp_exchange.hpp"

#include <algorithm>
#include <bit>

namespace warpgrain::profiler {
namespace {

template <class Function>
void for_each_lane(std::uint32_t lanes, Function function) {
  for (; lanes != 0; lanes &= lanes - 1) function(static_cast<std::uint32_t>(std::countr_zero(lanes)));
}

std::uint32_t bit(std::uint32_t lane) { return std::uint32_t{1} << lane; }

// Lanes are cut into segments by the mask in bits 8-12 of `bound`; bits 0-4 hold the last lane (the first
// one of shfl.up) that may be read.
void shuffle(const WarpRendezvous& lanes, std::uint32_t present) {
  for_each_lane(present, [&](std::uint32_t lane) {
    Rendezvous& asked = *lanes[lane];
    const std::uint32_t index = asked.index & 31;
    const std::uint32_t segment = asked.bound >> 8 & 31;
    const std::uint32_t first = lane & segment;
    const auto limit = static_cast<std::int32_t>(first | (asked.bound & 31 & ~segment));
    std::int32_t source = 0;
    switch (asked.meeting) {
      case Meeting::shuffle_up:
        source = static_cast<std::int32_t>(lane) - static_cast<std::int32_t>(index);
        break;
      case Meeting::shuffle_down:
        source = static_cast<std::int32_t>(lane + index);
        break;
      case Meeting::shuffle_butterfly:
        source = static_cast<std::int32_t>(lane ^ index);
        break;
      default:
        source = static_cast<std::int32_t>(first | (index & ~segment));
        break;
    }
    const bool inside = asked.meeting == Meeting::shuffle_up ? source >= limit : source <= limit;
    const std::uint32_t from = inside ? static_cast<std::uint32_t>(source) : lane;
    asked.holds = inside ? 1 : 0;
    asked.result = (present & bit(from)) != 0 ? lanes[from]->value : 0;
  });
}

void vote(const WarpRendezvous& lanes, std::uint32_t present, Meeting meeting) {
  std::uint32_t ballot = 0;
  for_each_lane(present, [&](std::uint32_t lane) { ballot |= lanes[lane]->value != 0 ? bit(lane) : 0; });
  const bool all = ballot == present, none = ballot == 0;
  const bool holds = meeting == Meeting::vote_all ? all : meeting == Meeting::vote_any ? !none : all || none;
  for_each_lane(present, [&](std::uint32_t lane) {
    lanes[lane]->result = ballot;
    lanes[lane]->holds = holds ? 1 : 0;
  });
}

void match(const WarpRendezvous& lanes, std::uint32_t present, bool all) {
  for_each_lane(present, [&](std::uint32_t lane) {
    std::uint32_t same = 0;
    for_each_lane(present, [&](std::uint32_t other) {
      same |= lanes[other]->value == lanes[lane]->value ? bit(other) : 0;
    });
    lanes[lane]->holds = same == present ? 1 : 0;
    lanes[lane]->result = all && same != present ? 0 : same;
  });
}

std::uint32_t reduced(Meeting meeting, std::uint32_t a, std::uint32_t b) {
  const auto as_signed = [](std::uint32_t x) { return static_cast<std::int32_t>(x); };
  switch (meeting) {
    case Meeting::reduce_add:
      return a + b;
    case Meeting::reduce_min_signed:
      return as_signed(a) < as_signed(b) ? a : b;
    case Meeting::reduce_max_signed:
      return as_signed(a) > as_signed(b) ? a : b;
    case Meeting::reduce_min_unsigned:
      return std::min(a, b);
    case Meeting::reduce_max_unsigned:
      return std::max(a, b);
    case Meeting::reduce_and:
      return a & b;
    case Meeting::reduce_or:
      return a | b;
    default:
      return a ^ b;
  }
}

void reduce(const WarpRendezvous& lanes, std::uint32_t present, Meeting meeting) {
  const auto first = static_cast<std::uint32_t>(std::countr_zero(present));
  auto result = static_cast<std::uint32_t>(lanes[first]->value);
  for_each_lane(present & ~bit(first), [&](std::uint32_t lane) {
    result = reduced(meeting, result, static_cast<std::uint32_t>(lanes[lane]->value));
  });
  for_each_lane(present, [&](std::uint32_t lane) { lanes[lane]->result = result; });
}

}  // namespace

void exchange_values(const WarpRendezvous& lanes, std::uint32_t present) {
  const auto first = static_cast<std::uint32_t>(std::countr_zero(present));
  const Meeting meeting = lanes[first]->meeting;
  switch (meeting) {
    case Meeting::warp_barrier:
      return;
    case Meeting::shuffle_up:
    case Meeting::shuffle_down:
    case Meeting::shuffle_butterfly:
    case Meeting::shuffle_index:
      return shuffle(lanes, present);
    case Meeting::vote_all:
    case Meeting::vote_any:
    case Meeting::vote_uniform:
    case Meeting::vote_ballot:
      return vote(lanes, present, meeting);
    case Meeting::match_any:
    case Meeting::match_all:
      return match(lanes, present, meeting == Meeting::match_all);
    case Meeting::active_mask:
      return for_each_lane(present, [&](std::uint32_t lane) { lanes[lane]->result = present; });
    case Meeting::elect:
      return for_each_lane(present, [&](std::uint32_t lane) {
        lanes[lane]->result = first;
        lanes[lane]->holds = lane == first ? 1 : 0;
      });
    default:
      return reduce(lanes, present, meeting);
  }
}

}  // namespace warpgrain::profiler
