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

// Those of a variant.
const CellSize& cell_size_of(const Variant& variant);
const WorkGroup& work_group_of(const Variant& variant);

}  // namespace warpgrain
