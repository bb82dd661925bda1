// `warpgrain record` as it is called: as a program of its own, for the layer goes into another.

#include <csignal>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/record_settings.hpp"
#include "command_fixture.hpp"
#include "profiler/subprocess.hpp"
#include "tests/paths.hpp"

namespace warpgrain::cli {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int status_of_program = 7;

class Record : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    build_ = std::filesystem::read_symlink("/proc/self/exe").parent_path().parent_path();
    program_ = {build_ / "tests" / "cli" / "recorded" / "warpgrain_recorded_program", data_ / "recorded.cl"};
  }

  int record(const std::vector<std::string>& options, const std::string& times = "1") {
    std::vector<std::string> words{build_ / "cli" / "warpgrain", "record"};
    words.insert(words.end(), options.begin(), options.end());
    words.insert(words.end(), {"--", program_[0], program_[1], times});
    const profiler::ProcessResult result = profiler::run_process(words);
    out_ = result.output;
    err_ = result.errors;
    return result.exit_status;
  }

  // In a group of its own, as a terminal has it, which gets SIGINT once `condition` of a shell holds. The
  // streams of the program go to files.
  int record_until(const std::string& condition, const std::vector<std::string>& options,
                   const std::string& times) {
    std::string command = (build_ / "cli" / "warpgrain").string() + " record";
    for (const std::string& option : options) command += " " + option;
    command +=
        " -- " + program_[0] + " " + program_[1] + " " + times + " >" + path("out") + " 2>" + path("err");
    const profiler::ProcessResult result =
        profiler::run_process({"/bin/bash", "-c",
                               "set -m; " + command + " & until " + condition +
                                   "; do sleep 0.005; done 2>/dev/null; kill -INT -- -$!; wait $!"});
    err_ = read("err");
    return result.exit_status;
  }

  // The launch files of the folder, and those that its index has: the same, each of which can be profiled.
  void expect_whole(const std::string& folder) {
    std::set<std::string> files, whole;
    for (const auto& entry : std::filesystem::directory_iterator(folder_ / folder))
      if (entry.path().extension() == ".sim") files.insert(entry.path().filename().string());
    for (const RecordedLaunch& launch : read_index(folder_ / folder))
      if (!launch.file.empty()) whole.insert(launch.file);
    EXPECT_EQ(files, whole);
    ASSERT_FALSE(whole.empty());
    EXPECT_EQ(call({"profile", path(folder + "/" + *whole.rbegin()), "--quiet"}), 0) << err_;
  }

  std::vector<std::string> kernels(const json& report) const {
    std::vector<std::string> names;
    for (const json& launch : report.at("launches")) names.push_back(launch.at("kernel"));
    return names;
  }

  const std::filesystem::path data_ = source_path("tests/cli/data");
  std::filesystem::path build_;
  std::vector<std::string> program_;
};

TEST_F(Record, CountsWhatHandWrittenLaunchFilesCount) {
  EXPECT_EQ(record({"--weights", "ptx", "--json", path("r.json")}), status_of_program) << err_;
  const json report = json::parse(read("r.json"));
  ASSERT_THAT(kernels(report), ElementsAre("scale", "sum_groups", "count_bits"));
  for (std::size_t k = 0; k < 3; ++k) {
    const std::string file = data_ / ("recorded-" + std::to_string(k + 1) + ".sim");
    ASSERT_EQ(call({"profile", file, "--build-options", "-DSTRIDE=7", "--weights", "ptx", "--json", "-"}), 0)
        << err_;
    const json by_hand = json::parse(out_).at("launches").at(0);
    const json& recorded = report.at("launches").at(k);
    EXPECT_EQ(recorded.at("global_size"), by_hand.at("global_size"));
    EXPECT_EQ(recorded.at("local_size"), by_hand.at("local_size"));
    EXPECT_EQ(recorded.at("totals"), by_hand.at("totals"));
  }
}

TEST_F(Record, LeavesTheProgramAsItIs) {
  const auto plain = profiler::run_process({program_[0], program_[1], "1"});
  ASSERT_EQ(plain.exit_status, status_of_program) << plain.errors;
  EXPECT_EQ(record({"--weights", "ptx"}), status_of_program);
  EXPECT_EQ(out_, plain.output);
}

TEST_F(Record, NamesWhatItDoesNotProfile) {
  record({"--weights", "ptx", "--quiet", "--json", path("r.json")});
  EXPECT_THAT(err_, HasSubstr("1 launch of count_bits: not profiled: a global work offset"));
  EXPECT_THAT(err_, HasSubstr("1 launch of paint: not profiled: an image"));
  EXPECT_EQ(error_lines(), 2U) << err_;
  EXPECT_THAT(read("r.json"), HasSubstr("1 launch of paint: not profiled: an image"));
}

TEST_F(Record, TakesTheLaunchesThatAreAskedFor) {
  record({"--weights", "ptx", "--quiet", "--json", path("r.json"), "--kernel", "sc*", "--every", "2",
          "--first", "3", "--save", path("saved")},
         "9");
  EXPECT_THAT(kernels(json::parse(read("r.json"))), ElementsAre("scale", "scale", "scale"));
  EXPECT_EQ(err_, "");
  // The second has other scalars than the first; the third has the second's contents, which stand once.
  EXPECT_NE(read("saved/launch-0001.sim"), read("saved/launch-0002.sim"));
  EXPECT_EQ(read("saved/launch-0002.sim"), read("saved/launch-0003.sim"));
  EXPECT_EQ(read("saved/program-0001.cl.options"), "-DSTRIDE=7\n");
  ASSERT_EQ(call({"profile", path("saved/launch-0003.sim"), "--quiet"}), 0) << err_;

  EXPECT_EQ(record({"--save", path("saved")}), 2);
  EXPECT_THAT(err_, HasSubstr("holds recorded launches"));
  write("mine/launch.sim", "");
  EXPECT_EQ(record({"--save", path("mine")}), 2);
  EXPECT_THAT(err_, HasSubstr("mine' holds files; expected an empty or a new folder"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "mine/launch.sim"));
}

TEST_F(Record, TakesLaunchesOfSeveralThreads) {
  record({"--weights", "ptx", "--quiet", "--json", path("r.json"), "--kernel", "repeat"}, "6");
  std::map<std::uint64_t, int> launches;  // by instructions, of which each step of `i` adds as many
  const json report = json::parse(read("r.json"));
  for (const json& launch : report.at("launches"))
    ++launches[launch.at("totals").at("warp_instructions").get<std::uint64_t>()];
  EXPECT_EQ(launches.size(), 6U);
  for (const auto& [instructions, count] : launches) EXPECT_EQ(count, 4) << instructions;
}

TEST_F(Record, StopsAtItsLimits) {
  record({"--weights", "ptx", "--largest", "1000", "--memory", "0"});
  EXPECT_THAT(err_, HasSubstr("1 launch of scale: not profiled: more than 1000 work-items"));
  EXPECT_THAT(err_, HasSubstr("1 launch of sum_groups: not profiled: recorded buffers may take 0 MiB"));
}

constexpr int status_of_sigint = 128 + SIGINT;

TEST_F(Record, ProfilesWhatAProgramThatCtrlCEndsHasLaunched) {
  EXPECT_EQ(record_until("test -s " + path("saved/launch-0003.sim"),
                         {"--weights", "ptx", "--json", path("r.json"), "--save", path("saved")}, "100000"),
            status_of_sigint)
      << err_;
  expect_whole("saved");
  const std::size_t recorded = read_index(folder_ / "saved").size();
  EXPECT_EQ(json::parse(read("r.json")).at("launches").size(), recorded);
  EXPECT_EQ(read("out"), "") << "the program has come to its end";
}

// Behind the program's end Ctrl-C is for the simulator, which may not have begun with the first launch.
TEST_F(Record, KeepsWhatIsSimulatedWhenCtrlCComes) {
  const std::string children = "$(sed -E 's|([0-9]+)|/proc/\\1/comm|g' /proc/$!/task/$!/children)";
  const std::string has_ended =
      "grep -q sum " + path("out") + " && ! grep -qs warpgrain_recor /dev/null " + children;
  EXPECT_EQ(
      record_until(has_ended, {"--weights", "ptx", "--json", path("r.json"), "--save", path("saved")}, "100"),
      status_of_sigint)
      << err_;
  EXPECT_THAT(err_, HasSubstr("not profiled: interrupted"));
  if (std::filesystem::exists(path("r.json"))) {
    EXPECT_LT(json::parse(read("r.json")).at("launches").size(), read_index(folder_ / "saved").size());
  } else {
    EXPECT_THAT(err_, HasSubstr("no launch of a kernel was profiled"));
  }
  expect_whole("saved");
}

TEST_F(Record, WritesNoReportOfNothing) {
  EXPECT_EQ(record({"--kernel", "paint", "--json", path("r.json"), "--html", path("r.html")}),
            status_of_program);
  EXPECT_THAT(err_, HasSubstr("no launch of a kernel was profiled; no report is written"));
  EXPECT_FALSE(std::filesystem::exists(path("r.json")));
  EXPECT_FALSE(std::filesystem::exists(path("r.html")));
}

TEST_F(Record, RefusesWhatCannotRun) {
  program_[0] = path("nowhere");
  EXPECT_EQ(record({}), 2);
  EXPECT_EQ(error_lines(), 1U) << err_;
  EXPECT_EQ(call({"record", "--first", "0", "--", "true"}), 2);
  EXPECT_EQ(call({"record", "--every", "0", "--", "true"}), 2);
}

}  // namespace
}  // namespace warpgrain::cli
