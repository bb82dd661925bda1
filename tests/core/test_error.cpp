#include <array>
#include <gtest/gtest.h>
#include <string>

#include "core/error.hpp"

namespace warpgrain {
namespace {

TEST(Error, NamesPlaceFindingAndExpectation) {
  try {
    throw_input_error("scene.json: gravity[2]", "'NaN'", "a finite number");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()), "scene.json: gravity[2]: 'NaN'; expected a finite number");
  }
}

TEST(Error, UnknownNameListsTheValidOnes) {
  const std::array<std::string_view, 2> valid{"cell", "unsorted"};
  try {
    throw_unknown_name("--order", "value", "cel", valid);
    FAIL();
  } catch (const InputError& e) {
    EXPECT_EQ(std::string(e.what()), "--order: unknown value 'cel'; valid: cell, unsorted");
  }
}

}  // namespace
}  // namespace warpgrain
