#pragma once
// What is asked of built-in functions where forces are evaluated: one row here. The other kernels of a step
// have OpenCL's default.

#include <array>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

struct MathMode {
  std::string_view name;  // value of the axis `math`
  std::string_view summary;
  std::string_view build_options;
  // What a float evaluation may be off, in bounds of the contact law.
  double error_factor;
  bool floats_alone;  // makes no difference in double
};

inline std::span<const MathMode> math_modes() {
  static constexpr std::array<MathMode, 4> rows{
      {{"default", "the accuracy that OpenCL asks for", "", 1, false},
       {"native", "the device's own approximations of roots and divisions", "-D NATIVE_MATH", 4, true},
       {"fast_relaxed", "the compiler may compute as if numbers were real, and finite",
        "-cl-fast-relaxed-math", 100, true},
       {"correctly_rounded", "divisions and roots rounded as IEEE 754 has it",
        "-cl-fp32-correctly-rounded-divide-sqrt", 1, true}}};
  return rows;
}

// The mode of a variant.
const MathMode& math_mode(const Variant& variant);

}  // namespace warpgrain
