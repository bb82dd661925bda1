// The commands as a user calls them, on small scenes, with every document that they write read back.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>

#include "cli/sweep_plan.hpp"
#include "cli/what_if_options.hpp"
#include "command_fixture.hpp"
#include "core/file_io.hpp"
#include "core/state_file.hpp"
#include "reports/report_json.hpp"
#include "reports/run_report.hpp"
#include "reports/sweep_index.hpp"
#include "variants/combinations.hpp"

namespace warpgrain::cli {
namespace {

using Commands = CommandTest;
using testing::HasSubstr;

TEST_F(Commands, ListIsTheSameAsTextAndJson) {
  ASSERT_EQ(call({"list", "variants", "--json", "-"}), 0) << err_;
  const auto json = nlohmann::json::parse(out_);
  EXPECT_EQ(json["format"], "warpgrain.list/1");
  ASSERT_EQ(call({"list", "variants"}), 0);
  for (const auto& row : json["variants"]) EXPECT_THAT(out_, HasSubstr(row["name"].get<std::string>()));
  EXPECT_EQ(json["variants"].size(), all_variants().size());
}

TEST_F(Commands, RunWritesItsDocumentAndItsState) {
  ASSERT_EQ(call({"run", "--scene", "head_on", "--steps", "20", "--sample-every", "5", "--json",
                  path("r.json"), "--state", path("s.csv"), "--vtk", path("vtk")}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("20 steps"));
  const reports::RunReport run = reports::read_run(path("r.json"));
  EXPECT_EQ(run.steps, 20u);
  EXPECT_EQ(run.energy.size(), 5u);
  EXPECT_EQ(read_state_file(path("s.csv")).size(), 2u);
  EXPECT_TRUE(std::filesystem::exists(path("vtk/particles_000000020.vtp")));
}

TEST_F(Commands, QuietLeavesResultsOnly) {
  ASSERT_EQ(call({"run", "--scene", "head_on", "--steps", "5", "--backend", "host", "--quiet"}), 0);
  EXPECT_EQ(out_, "");
  ASSERT_EQ(
      call({"run", "--scene", "head_on", "--steps", "5", "--backend", "host", "--quiet", "--json", "-"}), 0);
  EXPECT_EQ(nlohmann::json::parse(out_)["format"], "warpgrain.run/1");
}

TEST_F(Commands, ProfileDumpsAndReports) {
  write("k.cl",
        "kernel void halves(global int* a) {\n  int i = get_global_id(0);\n"
        "  if (i % 32 < 16) {  // branch: lower half\n    a[i] = a[i] * 3 + i / (a[i] + 1);\n  }\n}\n");
  const std::string launch = write("k.sim", "k.cl\nhalves\n64 1 1\n64 1 1\n<size=256 int fill=1 dump>\n");
  ASSERT_EQ(call({"profile", launch, "--weights", "ptx", "--json", path("r.json"), "--html", path("r.html")}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("Argument 'a': 256 bytes\n  a[0] = 3"));
  EXPECT_THAT(out_, HasSubstr("lower half"));
  const reports::Report report = reports::read_report(path("r.json"));
  ASSERT_EQ(report.launches.size(), 1u);
  EXPECT_EQ(report.launches[0].counters.totals.divergent_branches, 2u);
  EXPECT_THAT(read("r.html"), HasSubstr("lower half"));
  // The PTX beside the report runs the same.
  EXPECT_EQ(report.launches[0].ptx.file, "r.ptx");
  const std::string again = write("p.sim", "r.ptx\nhalves\n64 1 1\n64 1 1\n<size=256 int fill=1>\n");
  ASSERT_EQ(call({"profile", again, "--weights", "ptx", "--json", path("p.json")}), 0) << err_;
  EXPECT_EQ(reports::read_report(path("p.json")).launches[0].counters.totals,
            report.launches[0].counters.totals);
}

TEST_F(Commands, ProfileWeighsSpecialFunctionsOnAMachine) {
  ASSERT_EQ(call({"list", "machines", "--json", "-"}), 0);
  EXPECT_EQ(nlohmann::json::parse(out_)["machines"].size(), named_machines().size());
  write("k.cl",
        "kernel void roots(global float* a) {\n  a[get_global_id(0)] = "
        "native_rsqrt(a[get_global_id(0)]);\n}\n");
  const std::string launch = write("k.sim", "k.cl\nroots\n64 1 1\n64 1 1\n<size=256 float fill=2>\n");
  ASSERT_EQ(call({"profile", launch, "--machine", "fermi_c2050", "--json", path("r.json")}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("takes 8.0 times the cycles of 32-bit arithmetic"));
  const auto sfu = nlohmann::json::parse(read("r.json"))["launches"][0]["sfu"];
  EXPECT_EQ(sfu["instructions"], 2);
  EXPECT_EQ(sfu["cycles"], 16);
  EXPECT_EQ(reports::read_report(path("r.json")).machine->name, "fermi_c2050");
  EXPECT_EQ(call({"profile", launch, "--machine", "c2050"}), 2);
  EXPECT_THAT(err_, HasSubstr("unknown file or machine 'c2050'; valid: "));
  const std::string broken = write("m.json", R"({"format": "warpgrain.machine/1", "name": "m"})");
  EXPECT_EQ(call({"profile", launch, "--machine", broken}), 2);
  EXPECT_THAT(err_, HasSubstr("m.json: 'description' is missing"));
  EXPECT_EQ(error_lines(), 1u);
}

TEST_F(Commands, ProfileAnswersWhatIfs) {
  write("k.cl",
        "kernel void odd(global int* a) {\n  int i = get_global_id(0);\n"
        "  if (i % 2 == 1) {  // branch: odd ones\n    a[i] = a[i] * 3 + i / (a[i] + 1);\n  }\n}\n");
  const std::string launch = write("k.sim", "k.cl\nodd\n64 1 1\n64 1 1\n<size=256 int fill=1>\n");
  ASSERT_EQ(call({"profile", launch, "--what-if", "width=16,32", "order=launched,sorted", "--what-if",
                  "pool=64", "--json", path("r.json")}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("odd: what if (the run: 32 lanes, loop_postdom, as launched)"));
  const auto what_if = reports::read_report(path("r.json")).launches.at(0).counters.what_if;
  ASSERT_EQ(what_if.size(), 8u);  // two orders, two widths, each with a bound beside
  EXPECT_EQ(what_if[0].totals.divergent_branches, 4u);
  EXPECT_EQ(what_if[1].pool, 64u);
  EXPECT_EQ(what_if[4].order, "sorted:thread_instructions");
  EXPECT_EQ(what_if[4].totals.divergent_branches, 0u);
  EXPECT_EQ(what_if[7].totals.warp_instructions, what_if[6].totals.warp_instructions)
      << "sorting reaches the bound";
}

TEST_F(Commands, WhatIfsSortTheThreadsOfTheKernelsOfAStepThatHaveTheCount) {
  const std::vector<std::string> profile{"profile",     "--scene", "settled_bed",
                                         "--particles", "64",      "--what-if"};
  const auto with = [&](const std::string& question) {
    std::vector<std::string> words = profile;
    words.insert(words.end(), {question, "--json", path("r.json")});
    return call(words);
  };
  ASSERT_EQ(with("order=sorted:contact test"), 0) << err_;
  std::size_t answered = 0;
  const reports::Report report = reports::read_report(path("r.json"));
  for (const auto& launch : report.launches) answered += launch.counters.what_if.size();
  EXPECT_GT(answered, 0u);
  EXPECT_LT(answered, report.launches.size());
  EXPECT_EQ(with("order=sorted:moon phase"), 2);
  EXPECT_THAT(err_, HasSubstr("unknown thread count 'moon phase'; valid: thread_instructions, "));
  EXPECT_EQ(error_lines(), 1u);
}

TEST(WhatIfOptions, AreAllCombinationsOfTheirAxes) {
  using profiler::MergePolicy;
  const auto asked = [](std::vector<std::string> words) {
    return what_if_questions(words, 32, MergePolicy::loop_postdom);
  };
  EXPECT_EQ(
      asked({"width=4,8,16,32,64", "policy=loop_postdom,ipdom,min_pc", "order=launched,shuffled:7"}).size(),
      30u);
  EXPECT_EQ(asked({"width=8", "width=16,8"}).size(), 2u) << "an axis may come in pieces";
  const profiler::ThreadOrder launched;
  EXPECT_EQ(asked({"pool=64,128"}),
            (std::vector<profiler::WhatIf>{{32, MergePolicy::loop_postdom, launched, 64},
                                           {32, MergePolicy::loop_postdom, launched, 128}}));
  EXPECT_EQ(asked({"policy=min_pc", "pool=64"}),
            (std::vector<profiler::WhatIf>{{32, MergePolicy::min_pc, launched, 0},
                                           {32, MergePolicy::loop_postdom, launched, 64}}));
}

TEST_F(Commands, ProfileSaysWhatIsWrongAndEndsWith1) {
  write("k.cl",
        "kernel void k(global int* a) {\n  a[get_global_id(0)] = 3;\n  a[9] = get_global_id(0);\n}\n");
  const std::string launch = write("k.sim", "k.cl\nk\n128 1 1\n64 1 1\n<size=256 int fill=1>\n");
  ASSERT_EQ(call({"profile", launch, "--json", path("r.json"), "--html", path("r.html")}), 1) << err_;
  EXPECT_THAT(out_, HasSubstr("out_of_bounds: store of 4 bytes to global memory, 'a' at byte 256 of 256, "
                              "work-item (64, 0, 0) in work-group (1, 0, 0); 64 times"));
  EXPECT_THAT(out_, HasSubstr("k.cl:3 (PTX line "));
  EXPECT_EQ(reports::read_report(path("r.json")).launches[0].counters.diagnostics.size(), 3u);
  EXPECT_THAT(read("r.html"), HasSubstr("data_race"));
  // Errors stay when summaries go.
  ASSERT_EQ(call({"profile", launch, "--quiet"}), 1);
  EXPECT_EQ(out_, "");
  EXPECT_EQ(error_lines(), 3u) << err_;
  write("k.sim", "k.cl\nk\n1 1 1\n1 1 1\n<size=256 int fill=1 ro>\n");
  EXPECT_EQ(call({"profile", launch}), 1);
  EXPECT_THAT(out_, HasSubstr("read_only_write"));
  EXPECT_EQ(call({"profile", launch, "--unchecked"}), 0) << err_;
  EXPECT_THAT(out_, testing::Not(HasSubstr("wrong")));
}

TEST_F(Commands, ProfileStopsLoopsWithoutEnd) {
  write("k.cl", "kernel void k(global int* a) {\n  while (atomic_xchg(a, 1) == 1) {}\n}\n");
  const std::string launch = write("k.sim", "k.cl\nk\n64 1 1\n64 1 1\n<size=4 int fill=1>\n");
  for (const std::string checks : {"--quiet", "--unchecked"}) {
    ASSERT_EQ(call({"profile", launch, "--max-instructions", "100000", checks}), 1);
    EXPECT_THAT(out_ + err_, HasSubstr("instruction_limit"));
    EXPECT_THAT(out_ + err_, HasSubstr("waits for memory that another work-item would have to write"));
    EXPECT_THAT(out_ + err_, HasSubstr("given up"));
  }
  ASSERT_EQ(call({"profile", launch, "--max-instructions", "0"}), 2);
}

TEST_F(Commands, ProfileOfASceneFindsNothingWrong) {
  ASSERT_EQ(call({"profile", "--scene", "head_on", "--json", path("r.json")}), 0) << out_ << err_;
  EXPECT_THAT(read("r.json"), HasSubstr("\"diagnostics\": []"));
}

TEST_F(Commands, PaperPutsEveryFigureBesideItsReadings) {
  ASSERT_EQ(call({"run", "--scene", "settled_bed", "--particles", "200", "--steps", "5", "--json",
                  path("run.json"), "--quiet"}),
            0)
      << err_;
  ASSERT_EQ(call({"paper", "--scene", "settled_bed", "--particles", "200", "--steps", "20", "--samples", "2",
                  "--timed-steps", "5", "--machine", "hopper_h100", "--axis", "search=cells,verlet",
                  "--measured", path("run.json"), "--json", path("p.json")}),
            0)
      << err_;
  const auto paper = nlohmann::json::parse(read_text_file(path("p.json"), 1 << 20));
  EXPECT_EQ(paper["format"], "warpgrain.paper/1");
  EXPECT_EQ(paper["samples"].size(), 3u);
  EXPECT_FALSE(paper["paths"].empty());
  bool found = false;
  for (const auto& row : paper["rows"])
    if (row["quantity"] == "practical model, OpenCL") {
      found = true;
      ASSERT_EQ(row["measured"].size(), 2u);
      EXPECT_THAT(row["measured"][0]["on"].get<std::string>(), HasSubstr("here: "));
      EXPECT_THAT(row["measured"][1]["on"].get<std::string>(), HasSubstr("run.json: "));
    }
  EXPECT_TRUE(found);
  std::vector<std::string> variants;
  for (const auto& row : paper["rows"])
    if (const std::string section = row["section"]; section.find(" step on ") != std::string::npos) {
      variants.push_back(section + ": " + row["quantity"].get<std::string>());
      EXPECT_GT(row["simulated"].get<double>(), 0);
    }
  EXPECT_THAT(variants,
              testing::ElementsAre("least step on fermi_c2050: branchy/cells/cell/fp32/default",
                                   "least step on fermi_c2050: branchy/verlet/cell/fp32/default",
                                   "predicted step on hopper_h100: branchy/cells/cell/fp32/default",
                                   "predicted step on hopper_h100: branchy/verlet/cell/fp32/default"));
  EXPECT_THAT(out_, HasSubstr("27 sqrt(2) is 38.2"));
  EXPECT_EQ(call({"paper", "--samples", "0"}), 2);
  EXPECT_EQ(call({"paper", "--measured", path("none.json")}), 2);
  EXPECT_THAT(err_, HasSubstr("none.json"));
}

TEST_F(Commands, SweepResumesAndShards) {
  const std::vector<std::string> sweep{
      "sweep",   "--scene", "settled_bed", "--particles",        "64", "--at-step", "20",
      "--steps", "5",       "--axis",      "order=unsorted,cell"};
  const auto with = [&](std::vector<std::string> more) {
    more.insert(more.begin(), sweep.begin(), sweep.end());
    return more;
  };
  ASSERT_EQ(call(with({"--out", path("a")})), 0) << err_;
  const reports::SweepIndex all = reports::read_sweep(path("a/index.json"));
  ASSERT_EQ(all.cases.size(), 2u);
  for (const reports::SweepCase& row : all.cases) {
    EXPECT_EQ(row.status, reports::CaseStatus::done) << row.message;
    const reports::Report report = reports::read_report(path("a/" + row.report_file.value()));
    EXPECT_EQ(report.variant, row.variant);
    for (const auto& launch : report.launches)
      EXPECT_THAT(read("a/" + launch.ptx.file), HasSubstr(".entry " + launch.counters.kernel));
  }

  ASSERT_EQ(call(with({"--out", path("b"), "--shard", "2/2"})), 0) << err_;
  const reports::SweepIndex half = reports::read_sweep(path("b/index.json"));
  ASSERT_EQ(half.cases.size(), 1u);
  EXPECT_EQ(half.cases[0].variant, all.cases[1].variant);
  // Joined and shown, without running anything again.
  ASSERT_EQ(call({"merge", path("b"), path("a"), "--out", path("c"), "--quiet"}), 0) << err_;
  EXPECT_EQ(reports::read_sweep(path("c/index.json")).cases.size(), 2u);
  for (const reports::SweepCase& row : all.cases)
    EXPECT_TRUE(std::filesystem::exists(path("c/" + row.report_file.value())));
  ASSERT_EQ(call({"report", path("c"), "--html", path("c.html"), "--csv", path("c.csv"), "--markdown"}), 0)
      << err_;
  for (const reports::SweepCase& row : all.cases) {
    EXPECT_THAT(out_, HasSubstr("| `" + row.variant + "` |"));
    EXPECT_THAT(read("c.csv"), HasSubstr("\n" + row.variant + ",done,"));
    EXPECT_THAT(read("c.html"), HasSubstr(row.variant));
  }
  ASSERT_EQ(call({"report", path("a/" + all.cases[0].report_file.value())}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("where lanes idled"));
  EXPECT_EQ(call({"report", path("a/" + all.cases[0].report_file.value()), "--markdown"}), 2);
  EXPECT_EQ(call({"merge", path("none"), "--out", path("c")}), 2);
  EXPECT_THAT(err_, HasSubstr("none/index.json"));
  // The other half is added to what is there, and what is there stays untouched.
  const auto written = std::filesystem::last_write_time(path("b/" + half.cases[0].report_file.value()));
  ASSERT_EQ(call(with({"--out", path("b"), "--resume", "--jobs", "2"})), 0) << err_;
  const reports::SweepIndex joined = reports::read_sweep(path("b/index.json"));
  ASSERT_EQ(joined.cases.size(), 2u);
  EXPECT_EQ(joined.cases[0].variant, all.cases[0].variant);
  EXPECT_EQ(std::filesystem::last_write_time(path("b/" + half.cases[0].report_file.value())), written);
  // A folder of another sweep is not mixed with this one.
  EXPECT_EQ(call(with({"--out", path("b"), "--resume", "--seed", "1", "--at-step", "21"})), 2);
}

TEST(SweepPlan, SelectsByAxisInTableOrder) {
  EXPECT_EQ(swept_variants({}), one_value_at_a_time());
  std::vector<std::string> names;
  for (const Variant& variant :
       swept_variants({"precision=fp64,fp32", "contact=simple,branchy", "search=cells"}))
    names.push_back(variant.name());
  EXPECT_THAT(names,
              testing::ElementsAre("simple/cells/cell/fp32/default", "simple/cells/cell/fp64/default",
                                   "branchy/cells/cell/fp32/default", "branchy/cells/cell/fp64/default"));
  EXPECT_EQ(swept_variants({"order=all"}).size(), axis_named("order").values.size());
}

TEST(SweepPlan, ShardsCoverEveryCaseOnce) {
  for (std::size_t n = 1; n <= 4; ++n)
    for (std::size_t position = 0; position < 10; ++position) {
      std::size_t owners = 0;
      for (std::size_t i = 1; i <= n; ++i) owners += Shard{i, n}.has(position) ? 1 : 0;
      EXPECT_EQ(owners, 1u);
    }
}

}  // namespace
}  // namespace warpgrain::cli
