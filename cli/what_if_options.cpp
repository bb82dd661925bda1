#include "cli/what_if_options.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <sstream>
#include <string_view>

#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

constexpr std::string_view option = "--what-if";
constexpr std::array<std::string_view, 4> axis_names{"width", "policy", "order", "pool"};

struct Axes {
  std::vector<std::uint32_t> widths, pools;
  std::vector<profiler::MergePolicy> policies;
  std::vector<profiler::ThreadOrder> orders;
};

std::uint32_t number(const std::string& word, const std::string& value) {
  std::uint32_t result = 0;
  const char* const end = value.data() + value.size();
  const auto [stop, error] = std::from_chars(value.data(), end, result);
  if (error != std::errc{} || stop != end || result == 0)
    throw_input_error(option, fmt::format("'{}' in '{}'", value, word), "a whole number above 0");
  return result;
}

template <class T>
void add_once(std::vector<T>& values, const T& value) {
  if (std::find(values.begin(), values.end(), value) == values.end()) values.push_back(value);
}

void read_word(const std::string& word, Axes& axes) {
  const std::size_t equals = word.find('=');
  if (equals == std::string::npos || equals + 1 == word.size())
    throw_input_error(option, fmt::format("'{}'", word),
                      "NAME=VALUE,VALUE with NAME one of width, policy, order and pool (a launch file stands "
                      "before the option)");
  const std::string name = word.substr(0, equals);
  std::istringstream values(word.substr(equals + 1));
  for (std::string value; std::getline(values, value, ',');) {
    if (name == "width")
      add_once(axes.widths, number(word, value));
    else if (name == "policy")
      add_once(axes.policies, profiler::merge_policy_from_name(value, option));
    else if (name == "order")
      add_once(axes.orders, profiler::ThreadOrder::from_name(value, option));
    else if (name == "pool")
      add_once(axes.pools, number(word, value));
    else
      throw_unknown_name(option, "axis", name, axis_names);
  }
}

}  // namespace

std::vector<profiler::WhatIf> what_if_questions(const std::vector<std::string>& words,
                                                std::uint32_t run_width, profiler::MergePolicy run_policy) {
  Axes axes;
  for (const std::string& word : words) read_word(word, axes);
  const bool bounds_alone = axes.widths.empty() && axes.policies.empty() && axes.orders.empty();
  if (axes.widths.empty()) axes.widths = {run_width};
  if (axes.policies.empty()) axes.policies = {run_policy};
  if (axes.orders.empty()) axes.orders = {profiler::ThreadOrder{}};
  std::vector<profiler::WhatIf> questions;
  for (const profiler::ThreadOrder& order : axes.orders)
    for (const std::uint32_t width : axes.widths) {
      if (!bounds_alone)
        for (const profiler::MergePolicy policy : axes.policies)
          questions.push_back({width, policy, order, 0});
      for (const std::uint32_t pool : axes.pools) questions.push_back({width, run_policy, order, pool});
    }
  return questions;
}

}  // namespace warpgrain::cli
