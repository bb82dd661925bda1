#include "cli/sweep_plan.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <set>
#include <sstream>
#include <string_view>

#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

using Selection = std::map<std::string, std::set<std::string>>;

void select(Selection& selection, const std::string& option) {
  const auto equals = option.find('=');
  if (equals == std::string::npos || equals + 1 == option.size())
    throw_input_error("--axis", fmt::format("'{}'", option),
                      "name=value,value, as --axis contact=simple,branchy");
  const std::string name = option.substr(0, equals);
  std::istringstream values(option.substr(equals + 1));
  if (selection.count(name))
    throw_input_error("--axis", fmt::format("'{}' a second time", name), "each axis once");
  for (std::string value; std::getline(values, value, ',');) {
    Variant{}.set(name, value);  // refuses what is not in the tables
    selection[name].insert(value);
  }
}

}  // namespace

std::vector<Variant> swept_variants(const std::vector<std::string>& axis_options) {
  Selection selection;
  for (const std::string& option : axis_options) select(selection, option);
  std::vector<Variant> variants;
  for (const Variant& variant : all_variants()) {
    bool wanted = true;
    for (std::size_t a = 0; a < n_axes; ++a) {
      const auto chosen = selection.find(std::string(axes()[a].name));
      wanted = wanted && (chosen == selection.end() ||
                          chosen->second.count(std::string(variant.value(static_cast<AxisId>(a)))));
    }
    if (wanted) variants.push_back(variant);
  }
  if (variants.empty())
    throw_input_error("--axis", "no variant has these values together",
                      "a selection from `warpgrain list variants`");
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
