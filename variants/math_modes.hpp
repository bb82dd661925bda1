#pragma once
// What is asked of built-in functions where forces are evaluated: one row here. The other kernels of a step
// have OpenCL's default. And what every kernel makes of the smallest floats.

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

// What becomes of floats below the smallest normal one: one row here.
struct SubnormalMode {
  std::string_view name;  // value of the axis `denormals`
  std::string_view summary;
  std::string_view build_options;
  bool floats_alone;  // doubles keep them all the same on GPUs
};

inline std::span<const SubnormalMode> subnormal_modes() {
  static constexpr std::array<SubnormalMode, 2> rows{
      {{"keep", "floats below 1.2e-38 lose digits one by one", "", false},
       {"flush", "floats below 1.2e-38 are zero, going in and coming out", "-cl-denorms-are-zero", true}}};
  return rows;
}

// The modes of a variant.
const SubnormalMode& subnormal_mode(const Variant& variant);
const MathMode& math_mode(const Variant& variant);

}  // namespace warpgrain
