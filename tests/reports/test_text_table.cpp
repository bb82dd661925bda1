#include <gtest/gtest.h>

#include "core/error.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

TEST(TextTable, AlignsColumns) {
  TextTable table({{"name", TextTable::Align::left}, {"how many"}, {"last", TextTable::Align::left}});
  table.add_row({"a", "1,000", "x"});
  table.add_row({"longer", "7", ""});
  EXPECT_EQ(table.text(),
            "          how\n"
            "name     many  last\n"
            "------  -----  ----\n"
            "a       1,000  x\n"
            "longer      7\n");
}

TEST(TextTable, CountsLettersNotBytes) {
  TextTable table({{"é", TextTable::Align::left}, {"n"}});
  table.add_row({"ab", "1"});
  EXPECT_EQ(table.text(), "é   n\n--  -\nab  1\n");
}

TEST(TextTable, RefusesARowOfAnotherWidth) {
  TextTable table({{"a"}});
  EXPECT_THROW(table.add_row({"1", "2"}), InputError);
}

}  // namespace
}  // namespace warpgrain::reports
