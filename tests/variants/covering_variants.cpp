#include "covering_variants.hpp"

#include <algorithm>
#include <cctype>
#include <set>
#include <string>
#include <utility>

#include "variants/combinations.hpp"

namespace warpgrain {
namespace {

using Value = std::pair<std::size_t, std::string_view>;  // axis and its value
using Pairs = std::set<std::pair<Value, Value>>;

Value value_of(const Variant& variant, std::size_t axis) {
  return {axis, variant.value(static_cast<AxisId>(axis))};
}

std::size_t new_pairs(const Variant& variant, const Pairs& covered) {
  std::size_t count = 0;
  for (std::size_t a = 0; a < n_axes; ++a)
    for (std::size_t b = a + 1; b < n_axes; ++b)
      count += covered.contains({value_of(variant, a), value_of(variant, b)}) ? 0 : 1;
  return count;
}

// Changes one axis after the other to what covers most; `kept` are not touched.
Variant improved(Variant variant, const Pairs& covered, const std::set<std::size_t>& kept) {
  for (std::size_t a = 0; a < n_axes; ++a) {
    if (kept.contains(a)) continue;
    for (const AxisValue& value : axes()[a].values) {
      Variant other = variant;
      other.set(axes()[a].name, value.name);
      const bool is_better =
          !refusal(variant).empty() || new_pairs(other, covered) > new_pairs(variant, covered);
      if (refusal(other).empty() && is_better) variant = other;
    }
  }
  return variant;
}

}  // namespace

std::string test_name(const Variant& variant) {
  std::string name = variant.name();
  std::ranges::replace_if(
      name, [](unsigned char letter) { return std::isalnum(letter) == 0; }, '_');
  return name;
}

std::vector<Variant> covering_variants() {
  std::vector<Variant> variants;
  Pairs covered;
  for (std::size_t a = 0; a < n_axes; ++a)
    for (std::size_t b = a + 1; b < n_axes; ++b)
      for (const AxisValue& first : axes()[a].values)
        for (const AxisValue& second : axes()[b].values) {
          if (covered.contains({{a, first.name}, {b, second.name}})) continue;
          Variant variant;
          variant.set(axes()[a].name, first.name);
          variant.set(axes()[b].name, second.name);
          variant = improved(variant, covered, {a, b});
          if (!refusal(variant).empty()) continue;  // the two never go together
          variants.push_back(variant);
          for (std::size_t c = 0; c < n_axes; ++c)
            for (std::size_t d = c + 1; d < n_axes; ++d)
              covered.insert({value_of(variant, c), value_of(variant, d)});
        }
  return variants;
}

}  // namespace warpgrain
