#pragma once
// What section 6 of Washizawa & Nakahara's paper reckons about the practical model on a GPU, as formulas.

#include <cstdint>

namespace warpgrain::paper {

// Table 3, in particles a second: particles times time steps over wall seconds. Tesla C2050, and one core of
// a Xeon X5670 for the last.
inline constexpr double simple_cuda = 22'359e3;
inline constexpr double simple_opencl = 21'266e3;
inline constexpr double practical_opencl = 2'960e3;
inline constexpr double practical_cpp = 474e3;

// The machines behind it.
inline constexpr double gpu_lanes = 448, gpu_clock = 1.15e9;  // 1/s
inline constexpr double cpu_clock = 2.93e9, cpu_lanes = 4;    // of one core, with SSE
inline constexpr std::uint32_t warp_width = 32, sfu_lanes = 4;

// At most so many equal spheres touch one.
inline constexpr double most_contacts = 12;
// The candidates of a particle as the paper prints them.
inline constexpr double printed_candidates = 47;
inline constexpr double printed_peak_ratio = 44;
inline constexpr double printed_contact_share = 0.25;
inline constexpr double printed_sfu_calls = 2;  // a contact

// Arithmetic of all lanes of the GPU over that of one core: 448 / (2.93 / 1.15) / 4 = 44.
double peak_ratio();

// Eq. (13): equal spheres of diameter d in the closest packing of a volume, sqrt(2) volume / d^3; boundaries
// apart.
double closest_packing(double volume, double diameter);

// Spheres in 27 cells of the closest packing, cells a diameter wide: 27 sqrt(2) = 38.2.
double candidates();

// The share of its candidates that a particle can touch at most: 12 of them.
double contact_share();

// Lanes go different ways for M instructions: a warp of 32 is sped up by at most 32 / M.
double speed_up_bound(double instructions_at_once);

// N nested branches have up to 2^N paths.
double paths_bound(std::uint32_t nested_branches);

// 32 lanes pass four special-function units in 8 turns.
double sfu_bound();

}  // namespace warpgrain::paper
