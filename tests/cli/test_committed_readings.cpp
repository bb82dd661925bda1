// What documents claim of the committed readings, asked of the program again.

#include <filesystem>
#include <nlohmann/json.hpp>

#include "tests/cli/command_fixture.hpp"
#include "tests/paths.hpp"

namespace warpgrain::cli {
namespace {

class CommittedReadings : public CommandTest {
 protected:
  nlohmann::json order_of(const std::string& set) {
    const std::filesystem::path folder = source_path("reports/measured/h100-variants");
    std::vector<std::string> words{"compare", (folder / ("sweep-" + set + ".json")).string(), "--json", "-",
                                   "--measured"};
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.path().filename().string().starts_with("cuda-" + set + "-"))
        words.push_back(entry.path().string());
    EXPECT_EQ(call(words), 0) << err_;
    return nlohmann::json::parse(out_)["order"];
  }
};

TEST_F(CommittedReadings, PredictedTimesOrderTheVariantsOfASettledBed) {
  const nlohmann::json order = order_of("bed131072");
  EXPECT_GE(order["variants"].size(), 47U);
  EXPECT_EQ(order["by"], "predicted_seconds");
  EXPECT_GE(order["kendall_tau"], 0.8);
  EXPECT_GE(order["left_out"]["kendall_tau"][0], 0.8);
  EXPECT_LE(order["time_error"]["median"], 0.25);
}

TEST_F(CommittedReadings, OfFlowingGrainsTimesAreNearer) {
  const nlohmann::json order = order_of("shear131072");
  EXPECT_GE(order["variants"].size(), 47U);
  EXPECT_LE(order["time_error"]["median"], 0.25);
}

}  // namespace
}  // namespace warpgrain::cli
