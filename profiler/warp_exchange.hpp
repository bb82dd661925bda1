#pragma once
// What the lanes of a warp give each other: shuffles, votes, matches and reductions.

#include <array>
#include <cstdint>

#include "profiler/rendezvous.hpp"

namespace warpgrain::profiler {

// As PTX has it, whatever the width that lanes are merged by.
inline constexpr std::uint32_t lanes_of_warp = 32;

// The rendezvous of a warp's lanes by lane number, null where there is no lane.
using WarpRendezvous = std::array<Rendezvous*, lanes_of_warp>;

// Sets `result` and `holds` of the lanes in `present`, which all ask for the same meeting. NVIDIA, "Parallel
// Thread Execution ISA", chapters of the instructions. A shuffle from a lane that is not present, which PTX
// leaves undefined, gives 0.
void exchange_values(const WarpRendezvous& lanes, std::uint32_t present);

}  // namespace warpgrain::profiler
