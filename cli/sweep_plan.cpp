#include "cli/sweep_plan.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "core/error.hpp"
#include "variants/combinations.hpp"

namespace warpgrain::cli {
namespace {

// The values asked for, by axis.
using Selection = std::map<std::string, std::set<std::string>>;

void select(Selection& selection, const std::string& option) {
  const auto equals = option.find('=');
  if (equals == std::string::npos || equals + 1 == option.size())
    throw_input_error("--axis", fmt::format("'{}'", option),
                      "name=value,value, as --axis contact=simple,branchy, or name=all");
  const std::string name = option.substr(0, equals);
  std::istringstream values(option.substr(equals + 1));
  if (selection.count(name))
    throw_input_error("--axis", fmt::format("'{}' a second time", name), "each axis once");
  for (std::string value; std::getline(values, value, ',');) {
    // Refuses what is not in the tables.
    if (value == "all")
      axis_named(name);
    else
      Variant{}.set(name, value);
    selection[name].insert(value);
  }
}

}  // namespace

std::vector<Variant> swept_variants(const std::vector<std::string>& axis_options) {
  if (axis_options.empty()) return one_value_at_a_time();
  Selection selection;
  for (const std::string& option : axis_options) select(selection, option);
  std::vector<Variant> variants{Variant()};
  for (const Axis& axis : axes()) {
    const auto chosen = selection.find(std::string(axis.name));
    if (chosen == selection.end()) continue;
    std::vector<Variant> extended;
    for (const Variant& variant : variants)
      for (const AxisValue& value : axis.values)
        if (chosen->second.contains("all") || chosen->second.contains(std::string(value.name))) {
          extended.push_back(variant);
          extended.back().set(axis.name, value.name);
        }
    variants = std::move(extended);
  }
  const Variant first = variants.front();
  std::erase_if(variants, [](const Variant& variant) { return !refusal(variant).empty(); });
  if (variants.empty()) throw_input_error("--axis", first.name() + ": " + refusal(first));
  return variants;
}

std::vector<Variant> variants_that_compute_differently() {
  std::vector<Variant> variants = one_value_at_a_time();
  std::erase_if(variants, [](const Variant& variant) {
    return std::ranges::any_of(std::array{AxisId::order, AxisId::sort, AxisId::cell_size,
                                          AxisId::work_group_size, AxisId::reorder_every, AxisId::model},
                               [&](AxisId axis) { return variant.value(axis) != Variant().value(axis); });
  });
  return variants;
}

Shard Shard::parse(const std::string& text) {
  Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  const bool slash = index.ec == std::errc{} && index.ptr != end && *index.ptr == '/';
  const auto count = slash ? std::from_chars(index.ptr + 1, end, shard.count) : index;
  if (!slash || count.ec != std::errc{} || count.ptr != end || shard.index < 1 || shard.index > shard.count)
    throw_input_error("--shard", fmt::format("'{}'", text), "I/N with I from 1 to N, as 2/4");
  return shard;
}

std::string file_stem(const Variant& variant) {
  std::string name = variant.name();
  std::replace(name.begin(), name.end(), '/', '-');
  return name;
}

}  // namespace warpgrain::cli
