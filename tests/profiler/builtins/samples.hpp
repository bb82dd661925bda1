#pragma once
// Where functions are looked at: edge cases, their combinations, and random values.

#include <vector>

#include "tests/profiler/builtins/math_function.hpp"

namespace warpgrain::profiler::builtins {

template <class T>
struct Samples {
  std::vector<T> x, y, z;
  std::vector<int> n;
};

// The same samples for the same function on every machine.
template <class T>
Samples<T> samples_for(const MathFunction& function);

}  // namespace warpgrain::profiler::builtins
