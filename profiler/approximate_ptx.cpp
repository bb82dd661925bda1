#include "profiler/approximate_ptx.hpp"

#include <regex>

namespace warpgrain::profiler {

std::string with_displaced_approximations(std::string_view ptx) {
  static const std::regex approximate(R"(\b((?:sqrt|rsqrt|rcp|div)\.approx|div\.full)((?:\.ftz)?\.f32\b))");
  return std::regex_replace(std::string(ptx), approximate, "$1.displaced$2");
}

}  // namespace warpgrain::profiler
