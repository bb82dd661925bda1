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
};

inline std::span<const Order> orders() {
  static constexpr std::array<Order, 2> rows{
      {{"unsorted", "threads and memory stay in arrival order; neighbours are found through the sorted map",
        false},
       {"cell", "all properties are moved into cell order every step; threads run in that order", true}}};
  return rows;
}

// The order of a variant.
const Order& order_of(const Variant& variant);

}  // namespace warpgrain
