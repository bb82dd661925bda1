#include "analysis/pareto.hpp"

#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {
namespace {

bool dominates(const Costs& a, const Costs& b) {
  bool is_less = false;
  for (std::size_t k = 0; k < a.size(); ++k) {
    if (a[k] > b[k]) return false;
    is_less = is_less || a[k] < b[k];
  }
  return is_less;
}

}  // namespace

std::vector<std::optional<std::size_t>> dominated_by(std::span<const Costs> choices) {
  for (std::size_t k = 0; k < choices.size(); ++k) {
    if (choices[k].size() != choices.front().size())
      throw_input_error(fmt::format("choice {}", k), fmt::format("{} costs", choices[k].size()),
                        fmt::format("{}", choices.front().size()));
    for (const double cost : choices[k])
      if (std::isnan(cost)) throw_input_error(fmt::format("choice {}", k), "NaN", "a number");
  }
  std::vector<std::optional<std::size_t>> result(choices.size());
  for (std::size_t k = 0; k < choices.size(); ++k)
    for (std::size_t other = 0; other < choices.size() && !result[k]; ++other)
      if (dominates(choices[other], choices[k])) result[k] = other;
  return result;
}

}  // namespace warpgrain
