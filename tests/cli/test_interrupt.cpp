// Ctrl-C, and going on from what it left.

#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <thread>
#include <vector>

#include "cli/interrupt.hpp"
#include "command_fixture.hpp"

namespace warpgrain::cli {
namespace {

using testing::HasSubstr;

class Interrupt : public CommandTest {
 protected:
  // Calls, and sends SIGINT once the file is there.
  int call_until(const std::string& file, const std::vector<std::string>& words) {
    std::thread user([&] {
      while (!std::filesystem::exists(folder_ / file))
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
      std::raise(SIGINT);
    });
    const int status = call(words);
    user.join();
    return status;
  }
};

TEST_F(Interrupt, EndsARunThatKeepsWhatItHas) {
  const int status = call_until(
      "vtk/particles_000000000.vtp",
      {"run", "--scene", "settled_bed", "--particles", "20", "--backend", "host", "--steps", "1000000000",
       "--vtk", path("vtk"), "--json", path("run.json"), "--checkpoint", path("kept")});
  EXPECT_EQ(status, interrupted_status) << err_;
  EXPECT_THAT(err_, HasSubstr("with --resume goes on from there"));
  EXPECT_THAT(out_, HasSubstr("; interrupted"));
  EXPECT_THAT(read("run.json"), HasSubstr("\"ended_by\": \"interrupted\""));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "kept/state.csv"));
}

// In two parts or in one, the host takes the same steps.
TEST_F(Interrupt, ARunGoesOnFromItsCheckpoint) {
  const std::vector<std::string> run{"run",       "--scene", "settled_bed",    "--particles", "100",
                                     "--backend", "host",    "--sample-every", "500"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), run.begin(), run.end());
    return call(more);
  };
  ASSERT_EQ(with({"--steps", "3000", "--state", path("whole.csv"), "--json", path("whole.json")}), 0) << err_;
  ASSERT_EQ(with({"--steps", "2000", "--checkpoint", path("kept")}), 0) << err_;
  ASSERT_EQ(with({"--steps", "3000", "--checkpoint", path("kept"), "--resume", "--state", path("parts.csv"),
                  "--json", path("parts.json")}),
            0)
      << err_;
  EXPECT_EQ(read("whole.csv"), read("parts.csv"));
  EXPECT_THAT(read("parts.json"), HasSubstr("\"steps\": 3000"));
  const auto samples = [](const std::string& text) {
    return std::string(text.begin() + static_cast<std::ptrdiff_t>(text.find("\"energy\"")), text.end());
  };
  EXPECT_EQ(samples(read("whole.json")), samples(read("parts.json")));

  EXPECT_EQ(with({"--steps", "3000", "--precision", "fp64", "--checkpoint", path("kept"), "--resume"}), 2);
  EXPECT_THAT(err_, HasSubstr("run.json: a run with variant branchy/cells/cell/fp32/default; expected "));
  write("kept/contacts.csv", "particle_id,partner_id,x,y,z\n1,500,0,0,0\n");
  EXPECT_EQ(with({"--steps", "4000", "--checkpoint", path("kept"), "--resume"}), 2);
  EXPECT_THAT(err_, HasSubstr("a contact of 1 and 500; expected particles and walls of the scene"));
  EXPECT_EQ(error_lines(), 1U);
  EXPECT_EQ(with({"--steps", "10", "--checkpoint", path("nothing"), "--resume"}), 2);
  EXPECT_EQ(error_lines(), 1U);
}

TEST_F(Interrupt, ASweepDoesTheRestLater) {
  const std::vector<std::string> sweep{
      "sweep",   "--scene", "settled_bed", "--particles", "64", "--axis", "search=cells,two_phase,verlet",
      "--steps", "1",       "--out",       path("swept")};
  EXPECT_EQ(call_until("swept/branchy-cells-cell-fp32-default.report.json", sweep), interrupted_status)
      << err_;
  EXPECT_THAT(err_, HasSubstr("of its cases; the same call with --resume does the others"));
  std::vector<std::string> again = sweep;
  again.push_back("--resume");
  EXPECT_EQ(call(again), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("branchy/verlet/cell/fp32/default"));
}

// A document with the last of its cases taken away is what Ctrl-C leaves.
TEST_F(Interrupt, StudiesDoTheRestLater) {
  struct Study {
    std::vector<std::string> call;
    const char* rows;
  };
  const std::vector<Study> studies{
      {{"accuracy", "--particles", "20", "--at-step", "20", "--steps", "0", "--level", "force", "--axis",
        "precision=fp32,fp64", "--json", path("study.json")},
       "cases"},
      {{"stability", "--backend", "host", "--probe", "speed_high,stiffness_low", "--samples", "2",
        "--halvings", "1", "--axis", "precision=fp32", "--json", path("study.json")},
       "cells"}};
  for (const Study& study : studies) {
    ASSERT_EQ(call(study.call), 0) << err_;
    nlohmann::json whole = nlohmann::json::parse(read("study.json"));
    ASSERT_EQ(whole[study.rows].size(), 2U);
    nlohmann::json partial = whole;
    partial[study.rows].erase(1);
    partial[study.rows][0]["backend"] = study.call[0] == "accuracy" ? "kept" : "host";
    write("study.json", partial.dump());
    std::vector<std::string> again = study.call;
    again.push_back("--resume");
    ASSERT_EQ(call(again), 0) << err_;
    const nlohmann::json resumed = nlohmann::json::parse(read("study.json"));
    EXPECT_EQ(resumed[study.rows][0]["backend"], partial[study.rows][0]["backend"]);
    EXPECT_EQ(resumed[study.rows][1], whole[study.rows][1]);
    again.push_back("--threads");
    again.push_back("1");
    EXPECT_EQ(call(again), 2);
    EXPECT_THAT(err_, HasSubstr("expected that of this call, --resume aside"));
  }
}

}  // namespace
}  // namespace warpgrain::cli
