#pragma once
// Runs built-in functions in the simulator and says how far they are from the exact values.

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tests/profiler/builtins/math_function.hpp"

namespace warpgrain::profiler::builtins {

struct Measurement {
  std::string_view function;
  double limit = 0;
  double worst = 0;             // greatest error, in ULP
  std::size_t samples = 0;      // that OpenCL defines
  std::string worst_case = {};  // arguments, what came out, what should have
};

// One program for all of the functions, in T; those absent in T are left out.
template <class T>
std::vector<Measurement> measure(std::span<const MathFunction> functions);

// Runs vectors of `width` on the same samples; says of each function that does not give the scalars' bits
// what it gives. Functions of vectors are left out.
template <class T>
std::vector<std::string> differences_in_vectors(std::span<const MathFunction> functions, std::uint32_t width);

}  // namespace warpgrain::profiler::builtins
