#pragma once
// The arithmetics: one row here.

#include <array>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct Precision {
  std::string_view name;  // value of the axis `precision`
  std::string_view summary;
  bool is_fp64;
  bool has_fixed_places;  // on devices: variants/fixed_point.hpp
  bool has_half_history;  // on devices: variants/half_history.hpp
  // What an evaluation may be off, in bounds of the contact law for the arithmetic.
  double error_factor, error_factor_at_rest;
};

inline std::span<const Precision> precisions() {
  static constexpr std::array<Precision, 4> rows{
      {{"fp32", "everything in float", false, false, false, 1, 1},
       {"fp64", "everything in double", true, false, false, 1, 1},
       {"mixed",
        "forces in float, places in fixed point: overlaps are as exact 100 m from the origin as beside it",
        false, true, false, 1, 0.05},
       {"fp16_history",
        "everything in float, but what contact slots remember: tangential displacements in half", false,
        false, true, 40, 1}}};
  return rows;
}

// The arithmetic of a variant.
const Precision& precision_of(const Variant& variant);

}  // namespace warpgrain
