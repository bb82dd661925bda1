#include <algorithm>
#include <cstdint>
#include <gtest/gtest.h>
#include <random>
#include <span>
#include <vector>

#include "kernels/layout.h"
#include "variants/kernel_sources.hpp"
#include "variants/opencl_device.hpp"
#include "variants/sorts.hpp"

namespace warpgrain {
namespace {

TEST(Bitonic, SortsAsTheStandardLibraryDoes) {
  const std::vector<std::string> files{"sort/bitonic.cl"};
  const auto device = open_opencl_device({});
  device->build({{KernelSources().bundle(files), "-cl-std=CL1.2"}});
  for (const std::uint32_t n_keys :
       {2 * SORT_WORK_GROUP, 4 * SORT_WORK_GROUP, 16 * SORT_WORK_GROUP, 128 * SORT_WORK_GROUP}) {
    // Few cells, so that ties are broken by rank; all values; already sorted the wrong way round.
    for (const std::uint64_t n_cells : {std::uint64_t{5}, std::uint64_t{1} << 32, std::uint64_t{0}}) {
      std::mt19937_64 random(n_keys);
      std::vector<std::uint64_t> keys(n_keys);
      for (std::uint64_t rank = 0; rank < n_keys; ++rank) {
        keys[rank] = n_cells > 0 ? (random() % n_cells) << 32 | rank : n_keys - rank;
      }
      std::vector<std::uint64_t> sorted(n_keys);
      device->allocate(DeviceArray::cell_keys, 8 * keys.size());
      device->write(DeviceArray::cell_keys, std::as_bytes(std::span(keys)));
      for (const KernelLaunch& launch : bitonic_launches(0, n_keys)) device->launch(launch);
      device->read(DeviceArray::cell_keys, std::as_writable_bytes(std::span(sorted)));
      std::ranges::sort(keys);
      EXPECT_EQ(sorted, keys) << n_keys << " keys in " << n_cells << " cells";
    }
  }
}

}  // namespace
}  // namespace warpgrain
