#include "variants/combinations.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "variants/math_modes.hpp"
#include "variants/models.hpp"
#include "variants/orders.hpp"
#include "variants/precisions.hpp"
#include "variants/searches.hpp"
#include "variants/sorts.hpp"
#include "variants/tuning.hpp"

namespace warpgrain {
namespace {

template <class Row>
const Row& row_of(std::span<const Row> rows, const Variant& variant, AxisId axis) {
  return *std::ranges::find(rows, variant.value(axis), &Row::name);
}

// The first that differs in one more axis, if it has to, and makes sense.
Variant made_sensible(const Variant& variant, const Axis& kept) {
  if (refusal(variant).empty()) return variant;
  for (const Axis& axis : axes()) {
    if (axis.name == kept.name) continue;
    for (const AxisValue& value : axis.values) {
      Variant other = variant;
      other.set(axis.name, value.name);
      if (refusal(other).empty()) return other;
    }
  }
  return variant;
}

double bound_of(const Variant& variant, const ErrorBounds& bounds) {
  if (precision_of(variant).is_fp64) return bounds.fp64;
  return bounds.fp32 * math_mode(variant).error_factor;
}

}  // namespace

const ContactLaw& contact_law(const Variant& variant) {
  return row_of(contact_laws(), variant, AxisId::contact);
}
const Search& search_of(const Variant& variant) { return row_of(searches(), variant, AxisId::search); }
const Sort& sort_of(const Variant& variant) { return row_of(sorts(), variant, AxisId::sort); }
const CellSize& cell_size_of(const Variant& variant) {
  return row_of(cell_sizes(), variant, AxisId::cell_size);
}
const WorkGroup& work_group_of(const Variant& variant) {
  return row_of(work_groups(), variant, AxisId::work_group_size);
}
const ReorderInterval& reorder_interval_of(const Variant& variant) {
  return row_of(reorder_intervals(), variant, AxisId::reorder_every);
}
const Order& order_of(const Variant& variant) { return row_of(orders(), variant, AxisId::order); }
const Precision& precision_of(const Variant& variant) {
  return row_of(precisions(), variant, AxisId::precision);
}
const ModelExtent& model_of(const Variant& variant) {
  return row_of(model_extents(), variant, AxisId::model);
}
const SubnormalMode& subnormal_mode(const Variant& variant) {
  return row_of(subnormal_modes(), variant, AxisId::denormals);
}
const MathMode& math_mode(const Variant& variant) { return row_of(math_modes(), variant, AxisId::math); }

std::string refusal(const Variant& variant) {
  if (precision_of(variant).is_fp64 && math_mode(variant).floats_alone)
    return "--math " + std::string(math_mode(variant).name) +
           " says nothing of double: choose --math default";
  if (precision_of(variant).is_fp64 && subnormal_mode(variant).floats_alone)
    return "--denormals " + std::string(subnormal_mode(variant).name) +
           " says nothing of double: choose --denormals keep";
  if (precision_of(variant).has_half_history && !contact_law(variant).keeps_history)
    return "--precision " + std::string(precision_of(variant).name) +
           " is for laws with contact history, and --contact " + std::string(contact_law(variant).name) +
           " has none: choose --precision fp32";
  if (reorder_interval_of(variant).maps > 1 && !order_of(variant).moves_particles)
    return "--reorder_every " + std::string(reorder_interval_of(variant).name) + " says nothing of --order " +
           std::string(order_of(variant).name) + ", which moves no particles: choose --order cell";
  return {};
}

void require_sensible(const Variant& variant) {
  if (const std::string reason = refusal(variant); !reason.empty()) throw_input_error(variant.name(), reason);
}

std::vector<Variant> all_variants() {
  std::vector<Variant> variants{Variant()};
  for (const Axis& axis : axes()) {
    if (axis.is_tuning) continue;
    std::vector<Variant> extended;
    for (const Variant& variant : variants) {
      for (const AxisValue& value : axis.values) {
        extended.push_back(variant);
        extended.back().set(axis.name, value.name);
      }
    }
    variants = std::move(extended);
  }
  std::erase_if(variants, [](const Variant& variant) { return !refusal(variant).empty(); });
  return variants;
}

std::vector<Variant> one_value_at_a_time() {
  std::vector<Variant> variants{Variant()};
  for (const Axis& axis : axes()) {
    for (std::size_t k = 0; k < axis.values.size(); ++k) {
      if (k == axis.default_value) continue;
      Variant variant;
      variant.set(axis.name, axis.values[k].name);
      variants.push_back(made_sensible(variant, axis));
    }
  }
  return variants;
}

double error_bound(const Variant& variant) {
  return bound_of(variant, contact_law(variant).error_bounds) * precision_of(variant).error_factor;
}
double error_bound_at_rest(const Variant& variant) {
  return bound_of(variant, contact_law(variant).error_bounds_at_rest) *
         precision_of(variant).error_factor_at_rest;
}

}  // namespace warpgrain
