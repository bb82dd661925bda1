#include "variants/axes.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "variants/contact_laws.hpp"
#include "variants/math_modes.hpp"
#include "variants/models.hpp"
#include "variants/orders.hpp"
#include "variants/precisions.hpp"
#include "variants/searches.hpp"
#include "variants/sorts.hpp"
#include "variants/tuning.hpp"

namespace warpgrain {
namespace {

// The values of an axis whose rows say more than name and summary.
template <class Row>
std::span<const AxisValue> values_of(std::span<const Row> rows) {
  static const std::vector<AxisValue> values = [rows] {
    std::vector<AxisValue> named;
    for (const Row& row : rows) named.push_back({row.name, row.summary});
    return named;
  }();
  return values;
}

std::size_t find_value(const Axis& axis, std::string_view value, std::string_view where) {
  const auto it = std::ranges::find(axis.values, value, &AxisValue::name);
  if (it == axis.values.end()) {
    std::vector<std::string_view> valid;
    for (const AxisValue& v : axis.values) valid.push_back(v.name);
    throw_unknown_name(where, "value", value, valid);
  }
  return static_cast<std::size_t>(it - axis.values.begin());
}

// A default by name, so that a new row cannot shift it.
Axis axis(std::string_view name, std::string_view summary, std::string_view default_value,
          std::span<const AxisValue> values) {
  const auto found = std::ranges::find(values, default_value, &AxisValue::name);
  return {name, summary, static_cast<std::size_t>(found - values.begin()), values};
}
Axis tuning_axis(std::string_view name, std::string_view summary, std::string_view default_value,
                 std::span<const AxisValue> values) {
  Axis row = axis(name, summary, default_value, values);
  row.is_tuning = true;
  return row;
}

}  // namespace

std::span<const Axis> axes() {
  static const std::array<Axis, n_axes> table{
      {axis("contact", "the contact law", "branchy", values_of(contact_laws())),
       axis("search", "how contacts are found", "cells", values_of(searches())),
       axis("order", "the order of particles in memory", "cell", values_of(orders())),
       axis("precision", "the arithmetic", "fp32", values_of(precisions())),
       axis("math", "the accuracy of built-in functions", "default", values_of(math_modes())),
       tuning_axis("sort", "how the map of particles and cells is sorted", "bitonic", values_of(sorts())),
       tuning_axis("cell_size", "the cells of the collision grid", "1", values_of(cell_sizes())),
       tuning_axis("work_group_size", "work-items of a work-group", "128", values_of(work_groups())),
       tuning_axis("reorder_every", "how often particles are moved in memory, in maps", "1",
                   values_of(reorder_intervals())),
       tuning_axis("model", "how much of the model is computed", "needed", values_of(model_extents())),
       tuning_axis("denormals", "what becomes of the smallest floats", "keep",
                   values_of(subnormal_modes()))}};
  return table;
}

Variant::Variant() {
  for (std::size_t axis = 0; axis < n_axes; ++axis) index_[axis] = axes()[axis].default_value;
}

Variant Variant::parse(std::string_view name) {
  Variant variant;
  std::string_view rest = name;
  const auto next_word = [&rest] {
    const std::string_view word = rest.substr(0, rest.find('/'));
    rest.remove_prefix(std::min(word.size() + 1, rest.size()));
    return word;
  };
  std::string expected;
  for (const Axis& axis : axes())
    if (!axis.is_tuning) expected += fmt::format("{}{}", expected.empty() ? "" : "/", axis.name);
  expected += ", such as " + Variant().name();
  for (const Axis& axis : axes()) {
    if (axis.is_tuning) continue;
    const std::string_view word = next_word();
    if (word.empty()) throw_input_error("variant", fmt::format("'{}'", name), expected);
    variant.set(axis.name, word);
  }
  while (!rest.empty()) {
    const std::string_view word = next_word();
    const std::size_t equals = word.find('=');
    if (equals == std::string_view::npos)
      throw_input_error("variant", fmt::format("'{}'", name), expected + ", then AXIS=VALUE of tuning axes");
    variant.set(word.substr(0, equals), word.substr(equals + 1));
  }
  return variant;
}

const Axis& axis_named(std::string_view name) {
  const auto it = std::ranges::find(axes(), name, &Axis::name);
  if (it == axes().end()) {
    std::vector<std::string_view> valid;
    for (const Axis& a : axes()) valid.push_back(a.name);
    throw_unknown_name("variant", "axis", name, valid);
  }
  return *it;
}

void Variant::set(std::string_view axis, std::string_view value) {
  const Axis& named = axis_named(axis);
  index_[static_cast<std::size_t>(&named - axes().data())] =
      find_value(named, value, fmt::format("--{}", axis));
}

std::string_view Variant::value(AxisId axis) const {
  const auto i = static_cast<std::size_t>(axis);
  return axes()[i].values[index_[i]].name;
}

std::string Variant::name() const {
  std::string name;
  for (std::size_t k = 0; k < n_axes; ++k) {
    const Axis& axis = axes()[k];
    const std::string_view value = axis.values[index_[k]].name;
    if (!axis.is_tuning)
      name += fmt::format("{}{}", name.empty() ? "" : "/", value);
    else if (index_[k] != axis.default_value)
      name += fmt::format("/{}={}", axis.name, value);
  }
  return name;
}

}  // namespace warpgrain
