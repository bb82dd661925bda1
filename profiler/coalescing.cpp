#include "profiler/coalescing.hpp"

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>
#include <vector>

#include "profiler/vector_clones.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::uint32_t sectors_per_line = line_bytes / sector_bytes;

// Distinct values among ids[0..n): all pairs are compared, one distance at a time, which compilers turn into
// vector code that beats a hash table at these sizes. Entries of `padded` before ids match nothing.
class DistinctCounter {
 public:
  void clear() { n_ = 0; }
  void append(std::uint32_t id) {
    // Neighbouring lanes mostly repeat each other.
    ids()[n_] = id;
    n_ += n_ == 0 || ids()[n_ - 1] != id;
  }
  std::uint32_t count() {
    std::array<std::uint32_t, max_request_lanes> seen_before{};
    const std::uint32_t* id = ids();
    const std::size_t padded_n = (n_ + 7) / 8 * 8;
    for (std::size_t distance = 1; distance < n_; ++distance)
      for (std::size_t i = 0; i < padded_n; ++i) seen_before[i] |= id[i] == *(id + i - distance) ? 1U : 0U;
    std::uint32_t repeated = 0;
    for (std::size_t i = 0; i < n_; ++i) repeated += seen_before[i];
    return static_cast<std::uint32_t>(n_) - repeated;
  }

 private:
  static constexpr std::uint32_t no_id = std::numeric_limits<std::uint32_t>::max();
  std::uint32_t* ids() { return padded_.data() + max_request_lanes; }
  std::array<std::uint32_t, 2 * max_request_lanes> padded_ = [] {
    std::array<std::uint32_t, 2 * max_request_lanes> a{};
    a.fill(no_id);
    return a;
  }();
  std::size_t n_ = 0;
};

// For straddling accesses and addresses that lie far apart: no assumption at all.
RequestFootprint any_footprint(std::span<const std::uint64_t> addresses, std::uint32_t bytes) {
  std::vector<std::uint64_t> sectors;
  for (std::uint64_t address : addresses)
    for (std::uint64_t s = address / sector_bytes; s <= (address + bytes - 1) / sector_bytes; ++s)
      sectors.push_back(s);
  const auto distinct = [&] {
    std::sort(sectors.begin(), sectors.end());
    sectors.erase(std::unique(sectors.begin(), sectors.end()), sectors.end());
    return static_cast<std::uint32_t>(sectors.size());
  };
  RequestFootprint result;
  result.sectors = distinct();
  for (std::uint64_t& s : sectors) s /= sectors_per_line;
  result.lines = distinct();
  return result;
}

}  // namespace

WARPGRAIN_VECTOR_CLONES
RequestFootprint request_footprint(std::span<const std::uint64_t> addresses, std::uint32_t bytes) {
  // sectors[i + 1] is that of addresses[i], so that each has one before it; the first repeats itself.
  std::array<std::uint64_t, max_request_lanes + 1> sectors;
  const std::size_t n = addresses.size();
  sectors[0] = addresses[0] / sector_bytes;
  std::uint64_t straddles = 0;
  std::uint64_t lowest = sectors[0], highest = sectors[0];
  for (std::size_t i = 0; i < n; ++i) {
    const std::uint64_t sector = addresses[i] / sector_bytes;
    sectors[i + 1] = sector;
    straddles |= sector ^ ((addresses[i] + bytes - 1) / sector_bytes);
    lowest = std::min(lowest, sector);
    highest = std::max(highest, sector);
  }
  // Lines, not sectors, start the range, so that a sector's distance tells its line.
  lowest -= lowest % sectors_per_line;
  if (straddles != 0 || highest - lowest >= std::numeric_limits<std::uint32_t>::max())
    return any_footprint(addresses, bytes);
  std::array<std::uint32_t, max_request_lanes + 1> places;
  for (std::size_t i = 0; i <= n; ++i) places[i] = static_cast<std::uint32_t>(sectors[i] - lowest);
  std::uint32_t descends = 0;
  RequestFootprint ascending{1, 1};
  for (std::size_t i = 0; i < n; ++i) {
    descends |= places[i + 1] < places[i] ? 1U : 0U;
    ascending.sectors += places[i + 1] != places[i] ? 1U : 0U;
    ascending.lines += places[i + 1] / sectors_per_line != places[i] / sectors_per_line ? 1U : 0U;
  }
  if (descends == 0) return ascending;
  RequestFootprint result;
  DistinctCounter distinct;
  for (std::size_t i = 1; i <= n; ++i) distinct.append(places[i]);
  result.sectors = distinct.count();
  distinct.clear();
  for (std::size_t i = 1; i <= n; ++i) distinct.append(places[i] / sectors_per_line);
  result.lines = distinct.count();
  return result;
}

}  // namespace warpgrain::profiler
