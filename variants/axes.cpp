#include "variants/axes.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain {
namespace {

constexpr std::array<AxisValue, 1> search_values{{
    {"cells", "each work-item walks the 27 cells around its particle"},
}};
constexpr std::array<AxisValue, 2> order_values{{
    {"unsorted", "threads and memory stay in arrival order; neighbours are found through the sorted map"},
    {"cell", "all properties are moved into cell order every step; threads run in that order"},
}};
constexpr std::array<AxisValue, 2> precision_values{{
    {"fp32", "everything in float"},
    {"fp64", "everything in double"},
}};
constexpr std::array<AxisValue, 1> math_values{{
    {"default", "the accuracy that OpenCL asks for"},
}};

std::span<const AxisValue> contact_values() {
  static const std::vector<AxisValue> values = [] {
    std::vector<AxisValue> rows;
    for (const ContactLaw& law : contact_laws()) rows.push_back({law.name, law.summary});
    return rows;
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
std::size_t default_of(std::span<const AxisValue> values, std::string_view name) {
  return static_cast<std::size_t>(std::ranges::find(values, name, &AxisValue::name) - values.begin());
}

}  // namespace

std::span<const Axis> axes() {
  static const std::array<Axis, n_axes> table{{
      {"contact", "the contact law", default_of(contact_values(), "branchy"), contact_values()},
      {"search", "how contacts are found", default_of(search_values, "cells"), search_values},
      {"order", "the order of particles in memory", default_of(order_values, "cell"), order_values},
      {"precision", "the arithmetic", default_of(precision_values, "fp32"), precision_values},
      {"math", "the accuracy of built-in functions", default_of(math_values, "default"), math_values},
  }};
  return table;
}

Variant::Variant() {
  for (std::size_t axis = 0; axis < n_axes; ++axis) index_[axis] = axes()[axis].default_value;
}

Variant Variant::parse(std::string_view name) {
  Variant variant;
  std::string_view rest = name;
  for (std::size_t axis = 0; axis < n_axes; ++axis) {
    const std::size_t slash = rest.find('/');
    if ((slash == std::string_view::npos) != (axis + 1 == n_axes)) {
      throw_input_error("variant", fmt::format("'{}'", name),
                        "contact/search/order/precision/math, such as " + Variant().name());
    }
    variant.set(axes()[axis].name, rest.substr(0, slash));
    rest = slash == std::string_view::npos ? std::string_view{} : rest.substr(slash + 1);
  }
  return variant;
}

void Variant::set(std::string_view axis, std::string_view value) {
  const auto it = std::ranges::find(axes(), axis, &Axis::name);
  if (it == axes().end()) {
    std::vector<std::string_view> valid;
    for (const Axis& a : axes()) valid.push_back(a.name);
    throw_unknown_name("variant", "axis", axis, valid);
  }
  index_[static_cast<std::size_t>(it - axes().begin())] = find_value(*it, value, fmt::format("--{}", axis));
}

std::string_view Variant::value(AxisId axis) const {
  const auto i = static_cast<std::size_t>(axis);
  return axes()[i].values[index_[i]].name;
}

std::string Variant::name() const {
  std::string name;
  for (std::size_t axis = 0; axis < n_axes; ++axis) {
    if (axis > 0) name += '/';
    name += axes()[axis].values[index_[axis]].name;
  }
  return name;
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants{Variant()};
  for (const Axis& axis : axes()) {
    std::vector<Variant> extended;
    for (const Variant& variant : variants) {
      for (const AxisValue& value : axis.values) {
        extended.push_back(variant);
        extended.back().set(axis.name, value.name);
      }
    }
    variants = std::move(extended);
  }
  return variants;
}

}  // namespace warpgrain
