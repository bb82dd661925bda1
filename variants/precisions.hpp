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
};

inline std::span<const Precision> precisions() {
  static constexpr std::array<Precision, 2> rows{
      {{"fp32", "everything in float", false}, {"fp64", "everything in double", true}}};
  return rows;
}

// The arithmetic of a variant.
const Precision& precision_of(const Variant& variant);

}  // namespace warpgrain
