#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/error.hpp"
#include "variants/axes.hpp"
#include "variants/combinations.hpp"

namespace warpgrain {
namespace {

TEST(Axes, DefaultVariantIsTheSortedPracticalModelInFloat) {
  EXPECT_EQ(Variant().name(), "branchy/cells/cell/fp32/default");
}

TEST(Axes, NamesAreReadBack) {
  std::set<std::string> names;
  for (const auto& variants : {all_variants(), one_value_at_a_time()})
    for (const Variant& variant : variants) {
      EXPECT_EQ(Variant::parse(variant.name()), variant);
      names.insert(variant.name());
    }
  EXPECT_TRUE(names.contains("simple/cells/unsorted/fp64/default"));
}

TEST(Axes, NamesHaveTuningAxesWhereTheyAreNotAtTheirDefault) {
  EXPECT_EQ(Variant::parse("branchy/cells/cell/fp32/default/sort=bitonic").name(),
            "branchy/cells/cell/fp32/default");
  EXPECT_EQ(Variant::parse("branchy/cells/cell/fp32/default/sort=counting").value(AxisId::sort), "counting");
}

TEST(Axes, CombinationsThatMakeNoSenseAreRefusedWithTheReason) {
  const Variant variant = Variant::parse("branchy/cells/cell/fp64/native");
  EXPECT_EQ(refusal(variant), "--math native says nothing of double: choose --math default");
  EXPECT_THROW(require_sensible(variant), InputError);
  for (const Variant& sensible : all_variants()) EXPECT_NE(sensible, variant);
}

TEST(Axes, EveryValueIsInAVariantThatMakesSense) {
  std::set<std::string> values;
  for (const Variant& variant : one_value_at_a_time()) {
    EXPECT_EQ(refusal(variant), "") << variant.name();
    for (std::size_t a = 0; a < n_axes; ++a)
      values.insert(std::string(axes()[a].name) + '=' + std::string(variant.value(static_cast<AxisId>(a))));
  }
  for (const Axis& axis : axes())
    for (const AxisValue& value : axis.values)
      EXPECT_TRUE(values.contains(std::string(axis.name) + '=' + std::string(value.name))) << value.name;
}

std::string message_of(const std::string& name) {
  try {
    Variant::parse(name);
  } catch (const InputError& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Axes, RefusesUnknownNamesAndListsTheValidOnes) {
  EXPECT_EQ(message_of("branchy/cells/cel/fp32/default"),
            "--order: unknown value 'cel'; valid: unsorted, cell, morton, contact_count");
  EXPECT_EQ(message_of("branchy/cells"),
            "variant: 'branchy/cells'; expected contact/search/order/precision/math, such as "
            "branchy/cells/cell/fp32/default");
  EXPECT_EQ(message_of("branchy/cells/cell/fp32/default/more").substr(0, 9), "variant: ");
  EXPECT_EQ(message_of("branchy/cells/cell/fp32/default/sort=x"),
            "--sort: unknown value 'x'; valid: bitonic, counting");
  Variant variant;
  EXPECT_THROW(variant.set("colour", "red"), InputError);
}

}  // namespace
}  // namespace warpgrain
