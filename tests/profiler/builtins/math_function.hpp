#pragma once
// The table of built-in functions of real numbers: what each should give and how near it must come.

#include <functional>
#include <limits>
#include <span>
#include <string_view>

#include "tests/profiler/builtins/exact_value.hpp"

namespace warpgrain::profiler::builtins {

// Which of x, y, z (of the measured type) and n (int) a function takes.
enum class Inputs { x, xy, xyz, xn };

// Arguments of one sample, exactly as the kernel gets them. `digits` and `least_exponent` describe the
// measured type: 24 and -148, or 53 and -1073.
struct Arguments {
  double x, y, z;
  int n;
  int digits;
};

// Writes the exact result for the arguments.
using Reference = void (*)(mpfr_ptr result, const Arguments& arguments);

// ULP limits of a type that the function is not there for.
constexpr double absent = -1;
// The result is representable, or correctly rounded: compared bit by bit.
constexpr double exact = 0;

struct MathFunction {
  std::string_view name;
  std::string_view
      call;  // OpenCL C over x, y, z (of type T) and n (I); AS_T makes T of I; T3 is for three scalars
  Inputs inputs;
  double limit_float, limit_double;  // in ULP
  Reference reference;
  struct Details {
    double from = -10, to = 10;                      // where most samples of x are taken
    double widening = 1;                             // of that interval in double
    bool (*defined)(const Arguments&) = nullptr;     // samples that OpenCL says something about; null: all
    double (*absolute)(const Arguments&) = nullptr;  // an error that is allowed whatever the ULP
    bool signed_zero = true;                         // whether OpenCL fixes the sign of zero results
    std::string_view limit_text = {};                // where the limit is not a number of ULP
  } details = {};
};

std::span<const MathFunction> elementary_functions();
std::span<const MathFunction> other_math_functions();
std::span<const MathFunction> common_functions();
std::span<const MathFunction> approximate_functions();

}  // namespace warpgrain::profiler::builtins
