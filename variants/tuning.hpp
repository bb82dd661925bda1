#pragma once
// Sizes that can be tuned: one row here.

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct CellSize {
  std::string_view name;  // value of the axis `cell_size`
  std::string_view summary;
  double edges;  // of a cell, in the smallest that the search allows
};

inline std::span<const CellSize> cell_sizes() {
  static constexpr std::array<CellSize, 3> rows{
      {{"1", "cells as large as the largest diameter and the skin of lists", 1},
       {"1.5", "half as large again", 1.5},
       {"2", "twice as large", 2}}};
  return rows;
}

struct WorkGroup {
  std::string_view name;  // value of the axis `work_group_size`
  std::string_view summary;
  std::uint32_t work_items;  // a power of two
};

inline std::span<const WorkGroup> work_groups() {
  static constexpr std::array<WorkGroup, 3> rows{{{"64", "of kernels that work on particles", 64},
                                                  {"128", "of kernels that work on particles", 128},
                                                  {"256", "of kernels that work on particles", 256}}};
  return rows;
}

struct ReorderInterval {
  std::string_view name;  // value of the axis `reorder_every`
  std::string_view summary;
  std::uint32_t maps;  // every so many maps particles are moved in memory
};

inline std::span<const ReorderInterval> reorder_intervals() {
  static constexpr std::array<ReorderInterval, 4> rows{
      {{"1", "particles are moved in memory whenever the map is made", 1},
       {"4", "at every fourth map; between, neighbours are found through it", 4},
       {"16", "at every sixteenth map; between, neighbours are found through it", 16},
       {"64", "at every sixty-fourth map; between, neighbours are found through it", 64}}};
  return rows;
}

// Those of a variant.
const CellSize& cell_size_of(const Variant& variant);
const WorkGroup& work_group_of(const Variant& variant);
const ReorderInterval& reorder_interval_of(const Variant& variant);

}  // namespace warpgrain
