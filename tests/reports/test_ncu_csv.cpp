#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/file_io.hpp"
#include "reports/ncu_csv.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Pair;

class NcuCsv : public testing::Test {
 protected:
  std::vector<NcuLaunch> read(const std::string& text) {
    write_file_atomically(folder_ / "n.csv", text);
    return read_ncu_csv(folder_ / "n.csv");
  }
  std::string refusal(const std::string& text) {
    try {
      read(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "read";
  }
  TemporaryFolder folder_;
};

const std::string heading =
    R"("ID","Process ID","Kernel Name","Grid Size","smsp__inst_executed.sum","smsp__thread_inst_executed_per_inst_executed.ratio","device__attribute_name")"
    "\n"
    R"("","","","","inst","","")"
    "\n";

TEST_F(NcuCsv, RowsBecomeLaunches) {
  const auto launches =
      read("==PROF== Connected\nan application's line\n" + heading +
           R"x("0","77","force(const float4 *, int)","(32, 1, 1)","1,234,567","27.5","a ""GPU""")x" + "\r\n" +
           R"x("1","77","sort","(1, 1, 1)","12","n/a","b")x" + "\n");
  ASSERT_EQ(launches.size(), 2u);
  EXPECT_EQ(launches[0].kernel, "force");
  EXPECT_THAT(launches[0].metrics,
              ElementsAre(Pair("smsp__inst_executed.sum", 1234567),
                          Pair("smsp__thread_inst_executed_per_inst_executed.ratio", 27.5)));
  EXPECT_THAT(launches[1].metrics, ElementsAre(Pair("smsp__inst_executed.sum", 12)));
  // Ratios do not add up.
  EXPECT_THAT(counters_of(launches[0]), ElementsAre(Pair("warp_instructions", 1234567)));
}

TEST_F(NcuCsv, OtherFilesAreRefused) {
  EXPECT_THAT(refusal("no table\n"), HasSubstr("n.csv: no table of kernels; expected ncu --csv --page raw"));
  EXPECT_THAT(refusal("\"ID\",\"Kernel Name\",\"Metric Name\",\"Metric Value\"\n"),
              HasSubstr("n.csv:1: another page"));
  EXPECT_THAT(refusal(heading + "\"0\",\"77\"\n"), HasSubstr("n.csv:3: 2 fields"));
}

TEST(NcuMetrics, EachOnceAndAllSums) {
  const std::vector<std::string> names = ncu_metrics();
  EXPECT_THAT(names, testing::Contains("smsp__inst_executed.sum"));
  EXPECT_THAT(names, testing::Each(testing::EndsWith(".sum")));
  EXPECT_THAT(names, testing::Not(testing::Contains("")));
}

}  // namespace
}  // namespace warpgrain::reports
