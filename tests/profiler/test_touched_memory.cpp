// What launches touch, and what they touch together.

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "profiler/coalescing.hpp"
#include "profiler/device_buffer.hpp"
#include "profiler/profile.hpp"
#include "profiler/touched_memory.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

TouchedMemory memory_of(const std::set<std::uint64_t>& sectors) {
  TouchedMemory memory;
  for (const std::uint64_t sector : sectors) add_sector(memory, sector * sector_bytes);
  return memory;
}

TEST(TouchedMemory, NothingIsNothing) {
  TouchedMemory memory;
  EXPECT_EQ(bytes_of(memory), 0u);
  add(memory, {});
  EXPECT_TRUE(memory.empty());
}

TEST(TouchedMemory, ASectorCountsOnceWhoeverTouchesIt) {
  std::mt19937 random(std::random_device{}());
  for (int round = 0; round < 200; ++round) {
    std::set<std::uint64_t> own, more;
    // Chunks far apart, and several sectors of a chunk.
    for (auto* set : {&own, &more})
      for (unsigned n = random() % 300; n > 0; --n)
        set->insert((std::uint64_t{random() % 8} << 40) + random() % (round % 2 == 0 ? 100 : 100000));
    TouchedMemory memory = memory_of(own);
    EXPECT_EQ(bytes_of(memory), own.size() * sector_bytes);
    add(memory, memory_of(more));
    own.insert(more.begin(), more.end());
    EXPECT_EQ(memory, memory_of(own));
    EXPECT_EQ(bytes_of(memory), own.size() * sector_bytes);
  }
}

TEST(TouchedMemory, OfALaunchHasLoadsStoresAndAtomics) {
  const auto kernel = compile_kernel(
      "kernel void touches(global uint* out, global const uint* in, global uint* sum, global uint* rest) {\n"
      "  const uint i = get_global_id(0);\n"
      "  out[i] = in[16 * i];\n"
      "  atomic_add(sum + 8 * (i % 4), 1u);\n"
      "}\n",
      "touches");
  DeviceBuffer out(64 * 4), in(16 * 64 * 4), sum(32 * 4), rest(4096);
  ProfileOptions options;
  options.footprint = true;
  const LaunchCounters counters =
      profile_launch(*kernel, line_of(64, 32),
                     std::vector{KernelArgument::buffer(out.bytes()), KernelArgument::buffer(in.bytes()),
                                 KernelArgument::buffer(sum.bytes()), KernelArgument::buffer(rest.bytes())},
                     "", options);
  EXPECT_EQ(bytes_of(counters.touched), (8u + 64 + 4) * sector_bytes) << "nothing of `rest`";
  TouchedMemory twice = counters.touched;
  add(twice, counters.touched);
  EXPECT_EQ(twice, counters.touched);
}

}  // namespace
}  // namespace warpgrain::profiler
