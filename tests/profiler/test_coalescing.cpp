#include <algorithm>
#include <gtest/gtest.h>
#include <random>
#include <set>
#include <vector>

#include "profiler/coalescing.hpp"

namespace warpgrain::profiler {
namespace {

RequestFootprint by_sets(const std::vector<std::uint64_t>& addresses, std::uint32_t bytes) {
  std::set<std::uint64_t> sectors, lines;
  for (std::uint64_t address : addresses)
    for (std::uint64_t byte = address; byte < address + bytes; ++byte) {
      sectors.insert(byte / 32);
      lines.insert(byte / 128);
    }
  return {static_cast<std::uint32_t>(sectors.size()), static_cast<std::uint32_t>(lines.size())};
}

void expect_footprint(const std::vector<std::uint64_t>& addresses, std::uint32_t bytes, std::uint32_t sectors,
                      std::uint32_t lines) {
  const RequestFootprint footprint = request_footprint(addresses, bytes);
  EXPECT_EQ(footprint.sectors, sectors);
  EXPECT_EQ(footprint.lines, lines);
}

std::vector<std::uint64_t> strided(std::uint64_t base, std::uint64_t stride, std::size_t n = 32) {
  std::vector<std::uint64_t> addresses(n);
  for (std::size_t i = 0; i < n; ++i) addresses[i] = base + i * stride;
  return addresses;
}

TEST(Coalescing, KnownPatternsOf32Lanes) {
  expect_footprint(strided(4096, 4), 4, 4, 1);           // floats side by side
  expect_footprint(strided(4096, 16), 16, 16, 4);        // float4 side by side
  expect_footprint(strided(4096, 128), 4, 32, 32);       // a column of a matrix
  expect_footprint(strided(4096, 0), 4, 1, 1);           // all the same
  expect_footprint(strided(4096 + 4, 4), 4, 5, 2);       // moved by one float
  expect_footprint(strided(4096 + 30, 4, 1), 4, 2, 1);   // across a sector's end
  expect_footprint(strided(4096 + 126, 4, 1), 4, 2, 2);  // across a line's end
}

TEST(Coalescing, OrderOfLanesDoesNotCount) {
  auto addresses = strided(4096, 4);
  std::reverse(addresses.begin(), addresses.end());
  expect_footprint(addresses, 4, 4, 1);
}

TEST(Coalescing, FarApartAddresses) {
  expect_footprint({0, std::uint64_t{1} << 60, 64, std::uint64_t{1} << 60}, 4, 3, 2);
  // A distance of 2^32 sectors does not fold onto the same place.
  expect_footprint({std::uint64_t{32} << 32, 0}, 4, 2, 2);
}

TEST(Coalescing, RandomRequestsAgreeWithSets) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    std::mt19937_64 random(seed);
    const std::uint32_t bytes = 1U << random() % 5;
    const std::uint64_t range = std::uint64_t{1} << (4 + random() % 12);
    const bool aligned = random() % 2 == 0;
    std::vector<std::uint64_t> addresses(1 + random() % 64);
    for (std::uint64_t& address : addresses) {
      address = 100000 + random() % range;
      if (aligned) address -= address % bytes;
    }
    const RequestFootprint expected = by_sets(addresses, bytes),
                           footprint = request_footprint(addresses, bytes);
    EXPECT_EQ(footprint.sectors, expected.sectors) << "seed " << seed;
    EXPECT_EQ(footprint.lines, expected.lines) << "seed " << seed;
  }
}

}  // namespace
}  // namespace warpgrain::profiler
