#pragma once
// Searches whose lists outlive a step make map and lists anew only now and then. The launches of a report are
// those of a step that keeps them; this is what the others have beside.

#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "analysis/machine.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::reports {

struct ListMaking {
  // Of two makings: until the fastest particle, going on as it does, has moved as far as the lists allow.
  std::uint64_t steps_between = 1;
  std::uint64_t warp_instructions = 0, thread_instructions = 0;  // of one making
  std::optional<double> predicted_seconds;                       // of one, by the cost model

  // A step's share; 0 where nothing is predicted.
  double predicted_seconds_a_step() const {
    return predicted_seconds.value_or(0) / static_cast<double>(steps_between);
  }
};

// `step` are the launches of a step that keeps its lists, `lists` those that make them anew.
ListMaking list_making(std::span<const profiler::LaunchProfile> step,
                       std::span<const profiler::LaunchProfile> lists, std::uint64_t steps_between,
                       const std::optional<Machine>& machine);

// "lists are made anew about every 8 steps: 1,234 warp instructions, 150 us; 19 us a step".
std::string text_of(const ListMaking& making);

}  // namespace warpgrain::reports
