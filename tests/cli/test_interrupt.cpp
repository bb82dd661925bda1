// Ctrl-C, and going on from what it left.

#include <csignal>
#include <filesystem>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <thread>
#include <unistd.h>
#include <vector>

#include "cli/interrupt.hpp"
#include "command_fixture.hpp"
#include "profiler/subprocess.hpp"

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

  // Calls, and sends SIGINT once the command watches for it.
  int call_and_interrupt(const std::vector<std::string>& words) {
    std::thread user([] {
      struct sigaction action = {};
      do {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
        sigaction(SIGINT, nullptr, &action);
      } while (action.sa_handler == SIG_DFL);
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
  EXPECT_THAT(err_, HasSubstr("interrupted at step"));
  EXPECT_THAT(out_, HasSubstr("; interrupted"));
  EXPECT_THAT(read("run.json"), HasSubstr("\"ended_by\": \"interrupted\""));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "kept/state.csv"));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "vtk/contacts_000000000.vtp"));
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

// Else Ctrl-C would end a compiler, and the case at work with it.
TEST_F(Interrupt, DoesNotReachProgramsThatACaseWaitsFor) {
  const auto group_of_a_program = [] {
    std::istringstream fields(profiler::run_process({"/bin/cat", "/proc/self/stat"}).output);
    std::string process, name, state, parent;
    pid_t group = 0;
    fields >> process >> name >> state >> parent >> group;
    return group;
  };
  EXPECT_EQ(group_of_a_program(), getpgrp());
  const InterruptWatch watch;
  EXPECT_NE(group_of_a_program(), getpgrp());
}

TEST_F(Interrupt, ASweepDoesTheRestLater) {
  const std::vector<std::string> sweep{
      "sweep",   "--scene", "settled_bed", "--particles", "64", "--axis", "search=cells,two_phase,verlet",
      "--steps", "1",       "--out",       path("swept")};
  EXPECT_EQ(call_until("swept/branchy-cells-cell-fp32-default.report.json", sweep), interrupted_status)
      << err_;
  EXPECT_THAT(err_, HasSubstr("of its cases; the same call with --resume does the rest"));
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

// As PaperStudy leaves them, wherever Ctrl-C comes: before the first step, on the way, or behind the fall.
TEST_F(Interrupt, ThePaperGoesOnFromItsCheckpoint) {
  const std::vector<std::string> paper{"paper",         "--scene",
                                       "settled_bed",   "--particles",
                                       "100",           "--steps",
                                       "2000",          "--quiet",
                                       "--timed-steps", "5",
                                       "--samples",     "2",
                                       "--axis",        "search=cells,verlet",
                                       "--json",        path("paper.json"),
                                       "--html",        path("p.html"),
                                       "--checkpoint",  path("kept")};
  std::vector<std::string> again = paper;
  again.push_back("--resume");
  EXPECT_EQ(call_and_interrupt(paper), interrupted_status) << err_;
  EXPECT_THAT(err_, HasSubstr("variants; the same call with --resume does the rest"));
  const nlohmann::json partial = nlohmann::json::parse(read("paper.json"));
  EXPECT_TRUE(partial["rows"].empty());
  EXPECT_LE(partial["samples"].size(), 3U);
  ASSERT_EQ(call(again), 0) << err_;
  nlohmann::json whole = nlohmann::json::parse(read("paper.json"));
  std::vector<int> steps;
  for (const auto& sample : whole["samples"]) steps.push_back(sample["step"]);
  EXPECT_EQ(steps, std::vector<int>({0, 1000, 2000}));
  EXPECT_EQ(whole["fall"]["over"], true);

  // Behind the fall: the last row of each machine is missing, and one that is there is known again.
  nlohmann::json behind = whole;
  for (std::size_t k = behind["rows"].size(); k-- > 0;) {
    auto& row = behind["rows"][k];
    if (row["quantity"] == "branchy/cells/cell/fp32/default") row["simulated"] = 17.5;
    if (row["quantity"] == "branchy/verlet/cell/fp32/default") behind["rows"].erase(k);
  }
  ASSERT_EQ(behind["rows"].size() + 2, whole["rows"].size());
  write("paper.json", behind.dump());
  ASSERT_EQ(call(again), 0) << err_;
  const nlohmann::json resumed = nlohmann::json::parse(read("paper.json"));
  ASSERT_EQ(resumed["rows"].size(), whole["rows"].size());
  for (std::size_t k = 0; k < whole["rows"].size(); ++k) {
    if (whole["rows"][k]["quantity"] == "branchy/cells/cell/fp32/default")
      whole["rows"][k]["simulated"] = 17.5;
    EXPECT_EQ(resumed["rows"][k], whole["rows"][k]);
  }
  EXPECT_EQ(resumed["paths"], whole["paths"]);

  again.insert(again.end(), {"--threads", "1"});
  EXPECT_EQ(call(again), 2);
  EXPECT_THAT(err_, HasSubstr("expected that of this call, --resume aside"));
  EXPECT_EQ(call({"paper", "--resume"}), 2);
}

TEST_F(Interrupt, MeasurementsTakeTheReadingsThatAreLeft) {
  const std::vector<std::string> measure{"measure",   "--scene", "settled_bed",  "--particles", "20",
                                         "--backend", "host",    "--steps",      "1",           "--warm-up",
                                         "0",         "--json",  path("m.json"), "--repeats"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), measure.begin(), measure.end());
    return more;
  };
  std::vector<std::string> again = with({"6", "--resume"});
  ASSERT_EQ(call(with({"6"})), 0) << err_;
  nlohmann::json partial = nlohmann::json::parse(read("m.json"));
  ASSERT_EQ(partial["step"]["seconds"]["readings"].size(), 6U);
  ASSERT_EQ(partial["kernels"].size(), 1U);
  partial["kernels"][0]["seconds"]["readings"] = {1.5, 2.5};
  write("m.json", partial.dump());
  ASSERT_EQ(call(again), 0) << err_;
  const nlohmann::json resumed = nlohmann::json::parse(read("m.json"));
  EXPECT_EQ(resumed["step"], partial["step"]);
  const auto readings = resumed["kernels"][0]["seconds"]["readings"];
  ASSERT_EQ(readings.size(), 6U);
  EXPECT_EQ(readings[1], 2.5);

  // Enough of them that Ctrl-C comes before the last: no reading, or some.
  EXPECT_EQ(call_and_interrupt(with({"1000000000"})), interrupted_status) << err_;
  EXPECT_THAT(err_, HasSubstr("interrupted"));
}

}  // namespace
}  // namespace warpgrain::cli
