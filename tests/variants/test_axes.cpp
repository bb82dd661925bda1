#include <gtest/gtest.h>
#include <set>
#include <string>

#include "core/error.hpp"
#include "variants/axes.hpp"

namespace warpgrain {
namespace {

TEST(Axes, DefaultVariantIsTheSortedPracticalModelInFloat) {
  EXPECT_EQ(Variant().name(), "branchy/cells/cell/fp32/default");
}

TEST(Axes, NamesAreReadBack) {
  const std::vector<Variant> variants = all_variants();
  std::set<std::string> names;
  for (const Variant& variant : variants) {
    EXPECT_EQ(Variant::parse(variant.name()), variant);
    names.insert(variant.name());
  }
  std::size_t combinations = 1;
  for (const Axis& axis : axes()) combinations *= axis.values.size();
  EXPECT_EQ(names.size(), combinations);
  EXPECT_TRUE(names.contains("simple/cells/unsorted/fp64/default"));
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
            "--order: unknown value 'cel'; valid: unsorted, cell");
  EXPECT_EQ(message_of("branchy/cells"),
            "variant: 'branchy/cells'; expected contact/search/order/precision/math, such as "
            "branchy/cells/cell/fp32/default");
  EXPECT_EQ(message_of("branchy/cells/cell/fp32/default/more").substr(0, 9), "variant: ");
  Variant variant;
  EXPECT_THROW(variant.set("colour", "red"), InputError);
}

}  // namespace
}  // namespace warpgrain
