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
  bool by_contacts;      // in windows of that order, by the number of contacts
};

inline std::span<const Order> orders() {
  static constexpr std::array<Order, 4> rows{
      {{"unsorted", "threads and memory stay in arrival order; neighbours are found through the sorted map",
        false, false, false},
       {"cell",
        "all properties are moved into the order of cells, row by row, whenever the map is made; threads run "
        "in "
        "that order",
        true, false, false},
       {"morton", "the same with cells numbered along a Morton curve in tiles of 8 x 8 x 8", true, true,
        false},
       {"contact_count",
        "as cell, and in windows of 512 particles by their number of contacts; neighbours are found through "
        "the map",
        true, false, true}}};
  return rows;
}

// The order of a variant.
const Order& order_of(const Variant& variant);

}  // namespace warpgrain
