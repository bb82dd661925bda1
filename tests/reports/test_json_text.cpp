#include <algorithm>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "reports/json_text.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

TEST(JsonText, KeepsOrderAndPutsWhatIsShortOnALine) {
  const Json value{{"z", 1}, {"a", {1, 2.5, "x"}}, {"list", {{{"k", 1}, {"l", 2}}, {{"m", nullptr}}}}};
  EXPECT_EQ(json_text(value, "document"),
            R"({
 "z": 1,
 "a": [1,2.5,"x"],
 "list": [
  {"k":1,"l":2},
  {"m":null}
 ]
}
)");
}

TEST(JsonText, BreaksLongLinesButNotThoseOfNumbers) {
  const std::string a(70, 'a'), b(70, 'b');
  EXPECT_EQ(json_text(Json{{"list", {a, b}}}, "document"),
            fmt::format("{{\n \"list\": [\n  \"{}\",\n  \"{}\"\n ]\n}}\n", a, b));
  const std::string text = json_text(Json{{"counts", std::vector<int>(65, 1000)}}, "document");
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 3);
}

TEST(JsonText, NamesTheNumberThatIsNotFinite) {
  const Json value{{"energy", {{{"total", std::numeric_limits<double>::quiet_NaN()}}}}};
  try {
    json_text(value, "run");
    FAIL();
  } catch (const InputError& e) {
    EXPECT_THAT(e.what(), testing::HasSubstr("run.energy[0].total: 'nan'; expected a finite number"));
  }
}

TEST(JsonText, DoublesComeBackAsTheyWere) {
  const double value = 0.1 + 0.2;
  EXPECT_EQ(Json::parse(json_text(Json{{"v", value}}, "document"))["v"].get<double>(), value);
}

TEST(JsonText, BytesThatAreNoTextAreReplaced) {
  EXPECT_EQ(json_text(Json{{"v", "a\xFFz"}}, "document"), "{\"v\":\"a\xEF\xBF\xBDz\"}\n");
}

}  // namespace
}  // namespace warpgrain::reports
