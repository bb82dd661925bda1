// Footprints against sets, on kernels whose accesses are known.

#include <gtest/gtest.h>
#include <random>
#include <set>

#include "profiler/device_buffer.hpp"
#include "profiler/observers/footprint.hpp"
#include "profiler/profile.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {
namespace {

// Memory that begins at a sector, as a device's does.
template <class T>
struct DeviceVector {
  explicit DeviceVector(std::size_t n) : memory(n * sizeof(T)) {}
  std::span<T> values() {
    return {reinterpret_cast<T*>(memory.bytes().data()), memory.bytes().size() / sizeof(T)};
  }
  KernelArgument argument() { return KernelArgument::buffer(memory.bytes()); }
  DeviceBuffer memory;
};

FootprintCounters footprint_of(const Executable& executable, const LaunchShape& shape,
                               const std::vector<KernelArgument>& arguments, unsigned threads = 1) {
  ProfileOptions options;
  options.footprint = true;
  options.threads = threads;
  return *profile_launch(executable, shape, arguments, "", options).footprint;
}

TEST(Footprint, OfStridedRowsIsWhatTheyTouch) {
  // Each lane loads 16 bytes of a row of 64 and stores 16 at the same place; then one more float.
  const auto kernel = compile_kernel(
      "kernel void rows(global float4* out, global const float4* in, global float* rest) {\n"
      "  const uint i = get_global_id(0);\n"
      "  out[4 * i] = in[4 * i] + in[4 * i + 1];\n"
      "  rest[i] = 1;\n"
      "}\n",
      "rows");
  DeviceVector<float> out(16 * 256), in(16 * 256), rest(256);
  const FootprintCounters footprint =
      footprint_of(*kernel, line_of(256, 64), {out.argument(), in.argument(), rest.argument()});
  EXPECT_EQ(footprint.load_sectors, 256u);
  EXPECT_EQ(footprint.store_sectors, 256u + 256 / 8);
  EXPECT_EQ(footprint.part_stored_sectors, 256u) << "half of each row's sector, and all of `rest`";
  EXPECT_EQ(footprint.sectors, 2 * 256u + 256 / 8);
  EXPECT_EQ(footprint.group_load_sectors, footprint.load_sectors) << "no work-group touches another's";
  EXPECT_EQ(footprint.group_store_sectors, footprint.store_sectors);
}

TEST(Footprint, LeavesOutAtomicsAndLocalMemory) {
  const auto kernel = compile_kernel(
      "kernel void sums(global uint* sum, global uint* other, local uint* tile) {\n"
      "  tile[get_local_id(0)] = get_global_id(0);\n"
      "  barrier(CLK_LOCAL_MEM_FENCE);\n"
      "  atomic_add(sum, tile[get_local_size(0) - 1 - get_local_id(0)]);\n"
      "  if (get_global_id(0) == 0) other[8] = 1;\n"
      "}\n",
      "sums");
  DeviceVector<std::uint32_t> sum(1), other(16);
  const FootprintCounters footprint =
      footprint_of(*kernel, line_of(64, 32), {sum.argument(), other.argument(), KernelArgument::local(128)});
  EXPECT_EQ(footprint,
            (FootprintCounters{
                .group_store_sectors = 1, .store_sectors = 1, .part_stored_sectors = 1, .sectors = 1}));
}

TEST(Footprint, ABufferGivenTwiceCountsOnce) {
  const auto kernel = compile_kernel(
      "kernel void both(global float* a, global const float* b) { a[get_global_id(0)] = b[get_global_id(0)]; "
      "}\n",
      "both");
  DeviceVector<float> values(64);
  const FootprintCounters footprint =
      footprint_of(*kernel, line_of(64, 32), {values.argument(), values.argument()});
  EXPECT_EQ(footprint.load_sectors, 8u);
  EXPECT_EQ(footprint.store_sectors, 8u);
  EXPECT_EQ(footprint.sectors, 8u);
}

TEST(Footprint, OfRandomGathersIsThatOfSets) {
  constexpr std::uint64_t seed = 20261122;
  std::mt19937 random(seed);
  const auto kernel = compile_kernel(
      "kernel void gather(global uint* out, global const uint* index, global const uint* table, uint n) {\n"
      "  uint sum = 0;\n"
      "  for (uint k = 0; k < 1 + get_global_id(0) % n; ++k) sum += table[index[n * get_global_id(0) + k]];\n"
      "  out[get_global_id(0)] = sum;\n"
      "}\n",
      "gather");
  constexpr std::uint32_t n = 6, lanes = 512, group = 64, entries = 20000;
  DeviceVector<std::uint32_t> out(lanes), index(n * lanes), table(entries);
  for (std::uint32_t& i : index.values()) i = random() % entries;
  std::set<std::uint32_t> of_index, of_table;
  std::uint64_t of_groups = 0;
  for (std::uint32_t first = 0; first < lanes; first += group) {
    std::set<std::uint32_t> index_here, table_here;
    for (std::uint32_t lane = first; lane < first + group; ++lane)
      for (std::uint32_t k = 0; k < 1 + lane % n; ++k) {
        index_here.insert((n * lane + k) / 8);
        table_here.insert(index.values()[n * lane + k] / 8);
      }
    of_groups += index_here.size() + table_here.size();
    of_index.merge(index_here);
    of_table.merge(table_here);
  }
  for (const unsigned threads : {1u, 3u}) {
    SCOPED_TRACE(testing::Message() << "seed " << seed << ", " << threads << " threads");
    const FootprintCounters footprint =
        footprint_of(*kernel, line_of(lanes, group),
                     {out.argument(), index.argument(), table.argument(), scalar_of(n)}, threads);
    EXPECT_EQ(footprint.load_sectors, of_index.size() + of_table.size());
    EXPECT_EQ(footprint.group_load_sectors, of_groups);
    EXPECT_EQ(footprint.store_sectors, lanes / 8);
    EXPECT_EQ(footprint.part_stored_sectors, 0u);
  }
}

TEST(DistinctNumbers, AreThoseOfASet) {
  std::mt19937_64 random(7);
  DistinctNumbers distinct;
  for (int round = 0; round < 5; ++round) {
    std::set<std::uint64_t> set;
    for (int k = 0; k < 5000; ++k) {
      const std::uint64_t number = random() % 3000;
      EXPECT_EQ(distinct.insert(number), set.insert(number).second) << number;
    }
    distinct.clear();
  }
}

}  // namespace
}  // namespace warpgrain::profiler
