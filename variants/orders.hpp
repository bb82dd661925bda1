#pragma once
// The orders of particles in memory: one row here.

#include <array>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct Order {
  std::string_view name;  // value of the axis `order`
  std::string_view summary;
  bool moves_particles;  // into the order of the sorted map
  bool has_tiles;        // cells are numbered in tiles of 8 x 8 x 8
  std::string_view build_options;
};

inline std::span<const Order> orders() {
  static constexpr std::array<Order, 3> rows{
      {{"unsorted", "threads and memory stay in arrival order; neighbours are found through the sorted map",
        false, false, "-D ORDER_CELL=0"},
       {"cell",
        "all properties are moved into the order of cells, row by row, whenever the map is made; threads run "
        "in "
        "that order",
        true, false, "-D ORDER_CELL=1"},
       {"morton", "the same with cells numbered along a Morton curve in tiles of 8 x 8 x 8", true, true,
        "-D ORDER_CELL=1 -D ORDER_MORTON=1"}}};
  return rows;
}

// The order of a variant.
const Order& order_of(const Variant& variant);

}  // namespace warpgrain
