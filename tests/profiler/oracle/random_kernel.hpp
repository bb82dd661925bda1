#pragma once
// Random kernels that always end, stay in their buffers, race with nothing and compute exactly:
// whatever runs them must leave the same bytes. Loops within loops with trips of each lane's own, break,
// continue, goto (into loops, too), switch, early returns, calls, short circuits, barriers in uniform flow,
// atomics that commute.

#include <cstdint>
#include <string>

#include "profiler/launch.hpp"

namespace warpgrain::oracle {

// kernel void NAME(global const uint* in, global uint* out, global uint* sums, uint n)
struct RandomKernel {
  std::uint64_t seed = 0;
  std::string name;
  std::string source;  // names nothing that another seed's source names
  profiler::LaunchShape shape;

  static constexpr std::size_t in_words = 64;         // random words
  static constexpr std::size_t out_words_a_lane = 4;  // zeros; written and read by their lane alone
  static constexpr std::size_t sum_words = 8;         // zeros; changed by atomics alone
  static constexpr std::uint32_t n = 3;
};

// The same text for the same seed, everywhere.
RandomKernel random_kernel(std::uint64_t seed);

// In PTX, with the same parameters: jumps between any blocks, tables of them, predicated ends and accesses,
// functions with several ends. Beyond what compilers make of OpenCL C.
RandomKernel random_ptx_kernel(std::uint64_t seed);

}  // namespace warpgrain::oracle
