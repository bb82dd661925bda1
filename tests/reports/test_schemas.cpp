// The JSON Schemas under docs/schemas against documents as the program writes them, and against broken ones.

#include <functional>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/file_io.hpp"
#include "reports/comparison.hpp"
#include "reports/report_json.hpp"
#include "run_python.hpp"
#include "sample.hpp"
#include "tests/paths.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

// A document, and what was done to it.
struct Case {
  std::string what;
  std::string text;
};

// One answer a document: "valid", or what is wrong.
std::vector<std::string> validate(const std::string& schema, const std::vector<Case>& cases) {
  const TemporaryFolder folder;
  std::vector<std::filesystem::path> files{source_path("docs/schemas/") + schema};
  for (const Case& document : cases) {
    files.push_back(folder / (std::to_string(files.size()) + ".json"));
    write_file_atomically(files.back(), document.text);
  }
  return run_python("validate.py", files);
}

void expect_valid(const std::string& schema, const std::vector<Case>& cases) {
  const auto answers = validate(schema, cases);
  ASSERT_EQ(answers.size(), cases.size());
  for (std::size_t k = 0; k < cases.size(); ++k) EXPECT_EQ(answers[k], "valid") << cases[k].what;
}

// What to do to a document, and the place that validation must name.
struct Damage {
  std::string what, place;
  std::function<void(Json&)> apply;
};

void expect_refused(const std::string& schema, const std::string& text, const std::vector<Damage>& damages) {
  std::vector<Case> cases;
  for (const Damage& damage : damages) {
    Json document = Json::parse(text);
    damage.apply(document);
    cases.push_back({damage.what, document.dump()});
  }
  const auto answers = validate(schema, cases);
  ASSERT_EQ(answers.size(), cases.size());
  for (std::size_t k = 0; k < cases.size(); ++k)
    EXPECT_TRUE(answers[k].starts_with(damages[k].place + ": ")) << damages[k].what << ": " << answers[k];
}

TEST(Schemas, ReportsAsWrittenAreValid) {
  Report bare = sample::report();
  bare.scene.reset();
  bare.variant.reset();
  bare.particles.reset();
  bare.step.reset();
  bare.machine.reset();
  Report predicted = sample::report();
  predicted.machine = load_machine("hopper_h100");
  expect_valid("report-1.schema.json", {{"of a scene", report_json(sample::report())},
                                        {"of a launch file", report_json(bare)},
                                        {"with predicted times", report_json(predicted)}});
}

TEST(Schemas, BrokenReportsAreRefused) {
  expect_refused(
      "report-1.schema.json", report_json(sample::report()),
      {{"another version", "$.format", [](Json& d) { d["format"] = "warpgrain.report/2"; }},
       {"no limits", "$", [](Json& d) { d.erase("limits"); }},
       {"an unknown key", "$.launches[1].totals",
        [](Json& d) { d["launches"][1]["totals"]["occupancy"] = 1; }},
       {"a missing total", "$.launches[0].totals",
        [](Json& d) { d["launches"][0]["totals"].erase("branches"); }},
       {"a negative count", "$.launches[0].warps", [](Json& d) { d["launches"][0]["warps"] = -2; }},
       {"half an instruction", "$.launches[0].totals.sfu_instructions",
        [](Json& d) { d["launches"][0]["totals"]["sfu_instructions"] = 0.5; }},
       {"a ratio above 1", "$.launches[0].totals.simt_efficiency",
        [](Json& d) { d["launches"][0]["totals"]["simt_efficiency"] = 1.01; }},
       {"NaN as null", "$.launches[0].totals.active_lanes",
        [](Json& d) { d["launches"][0]["totals"]["active_lanes"] = nullptr; }},
       {"an unknown class", "$.launches[0].totals.instruction_mix",
        [](Json& d) {
          d["launches"][0]["totals"]["instruction_mix"]["tensor"] = {{"warp", 1}, {"thread", 1}};
        }},
       {"two sizes", "$.launches[2].local_size",
        [](Json& d) {
          d["launches"][2]["local_size"] = {8, 1};
        }},
       {"an unknown policy", "$.launches[0].policy", [](Json& d) { d["launches"][0]["policy"] = "min_sp"; }},
       {"a bound with a policy", "$.launches[0].what_if[2]",
        [](Json& d) {
          d["launches"][0]["what_if"][2]["policy"] = "ipdom";
          d["launches"][0]["what_if"][2]["warps"] = 1;
        }},
       {"an unknown order", "$.launches[0].what_if[0].order",
        [](Json& d) { d["launches"][0]["what_if"][0]["order"] = "random"; }},
       {"a share above 1", "$.launches[0].branches[0].loss_share",
        [](Json& d) { d["launches"][0]["branches"][0]["loss_share"] = 1.5; }},
       {"a machine without sources", "$.machine.lanes",
        [](Json& d) { d["machine"]["lanes"].erase("source"); }},
       {"a module without a hash", "$.launches[0].ptx",
        [](Json& d) { d["launches"][0]["ptx"].erase("hash"); }},
       {"no text at first", "$.launches[0].source",
        [](Json& d) { d["launches"][0]["source"].erase("text"); }},
       {"a hash of another kind", "$.launches[0].source.hash",
        [](Json& d) { d["launches"][0]["source"]["hash"] = "d41d8cd98f00b204e9800998ecf8427e"; }},
       {"no launches", "$.launches", [](Json& d) { d["launches"] = Json::array(); }}});
}

TEST(Schemas, Runs) {
  const std::string run = run_json(sample::run());
  expect_valid("run-1.schema.json", {{"as written", run}});
  expect_refused(
      "run-1.schema.json", run,
      {{"no particles", "$.particles", [](Json& d) { d["particles"] = 0; }},
       {"an unknown back end", "$.backend", [](Json& d) { d["backend"] = "vulkan"; }},
       {"an unknown end", "$.ended_by", [](Json& d) { d["ended_by"] = "boredom"; }},
       {"negative kinetic energy", "$.energy[1].rotational",
        [](Json& d) { d["energy"][1]["rotational"] = -1e-9; }},
       {"a kernel without calls", "$.kernels[0]", [](Json& d) { d["kernels"][0].erase("calls"); }}});
}

TEST(Schemas, Measurements) {
  const std::string measured = measured_json(sample::measured());
  expect_valid("measured-1.schema.json", {{"as written", measured}});
  expect_refused(
      "measured-1.schema.json", measured,
      {{"no device", "$", [](Json& d) { d.erase("device"); }},
       {"no reading", "$.kernels[0].seconds.readings",
        [](Json& d) { d["kernels"][0]["seconds"]["readings"] = Json::array(); }},
       {"a flat size", "$.kernels[0].global_size", [](Json& d) { d["kernels"][0]["global_size"] = {64}; }}});
}

TEST(Schemas, Comparisons) {
  Comparison comparison = compare({{"k", {{"warp_instructions", 4}, {"branches", 0}}}, {"l", {}}},
                                  {{"k", {{"warp_instructions", 5}, {"branches", 2}}}}, {});
  comparison.generator = this_generator();
  const std::string kernels = comparison_json(comparison);
  comparison.order.emplace();
  comparison.order->rows = {{"x", 1, {}, 2}, {"y", 3, {}, 4}};
  comparison.order->tau = 1;
  comparison.order->interval = TauInterval{-1, 1};
  const std::string by_count = comparison_json(comparison);
  comparison.order->rows = {{"x", 1, 2.5, 2}, {"y", 3, 4.5, 4}};
  comparison.order->by_time = true;
  comparison.order->error = PredictionError{0.1, 0.2};
  comparison.order->left_out = LeftOut{{-1, 1}, {0.1, 0.2}};
  expect_valid("comparison-1.schema.json",
               {{"of kernels", kernels}, {"of a sweep", by_count}, {"by time", comparison_json(comparison)}});
  expect_refused("comparison-1.schema.json", comparison_json(comparison),
                 {{"a tau of 2", "$.order.kendall_tau", [](Json& d) { d["order"]["kendall_tau"] = 2; }},
                  {"no metric", "$.differences[0]", [](Json& d) { d["differences"][0].erase("metric"); }}});
}

TEST(Schemas, Sweeps) {
  const std::string sweep = sweep_json(sample::sweep());
  expect_valid("sweep-1.schema.json", {{"as written", sweep}});
  expect_refused(
      "sweep-1.schema.json", sweep,
      {{"an unknown status", "$.cases[0].status", [](Json& d) { d["cases"][0]["status"] = "fine"; }},
       {"a failure without a reason", "$.cases[1]", [](Json& d) { d["cases"][1].erase("message"); }},
       {"a headline of no report", "$.cases[0]", [](Json& d) { d["cases"][0].erase("report_file"); }},
       {"no time at all", "$.cases[0].backends[0].seconds_per_step",
        [](Json& d) { d["cases"][0]["backends"][0]["seconds_per_step"] = 0; }},
       {"half an error", "$.cases[0].backends[0].force_error",
        [](Json& d) { d["cases"][0]["backends"][0]["force_error"].erase("maximum"); }}});
}

TEST(Schemas, Machines) {
  std::vector<Case> machines;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("profiler/machines")))
    if (entry.path().extension() == ".json")
      machines.push_back({entry.path().filename().string(), read_text_file(entry.path(), 1 << 20)});
  EXPECT_GE(machines.size(), 4u);
  expect_valid("machine-1.schema.json", machines);
  expect_refused("machine-1.schema.json", machines.at(0).text,
                 {{"no lanes", "$", [](Json& d) { d.erase("lanes"); }},
                  {"half a lane", "$.sfu_lanes.value", [](Json& d) { d["sfu_lanes"]["value"] = 0.5; }},
                  {"a value without a source", "$.clock", [](Json& d) { d["clock"].erase("source"); }},
                  {"an odd width", "$.warp_width.value", [](Json& d) { d["warp_width"]["value"] = 24; }}});
}

// contracts.md's example of a scene.
constexpr const char* example_scene =
    R"({ "format": "warpgrain.scene/1", "name": "two_spheres", "gravity": [0, 0, -9.81],
  "model": { "contact": "practical", "slip_history": "clip", "normal_force": "signed" },
  "materials": [ { "name": "glass", "density": 2500, "youngs_modulus": 1e7, "poisson_ratio": 0.3 } ],
  "contacts": [ { "between": ["glass", "glass"], "restitution": 0.8, "friction": 0.5 } ],
  "particles": [ { "material": "glass", "radius": 0.005, "position": [0,0,0], "velocity": [0,0,1],
                   "angular_velocity": [0,0,0] } ],
  "walls": [ { "material": "glass", "plane": { "point": [0,0,-1], "normal": [0,0,1] } },
             { "material": "glass", "rectangle": { "corner": [0,0,0], "edges": [[1,0,0],[0,1,0]] } } ],
  "time": { "step": "auto", "end": { "steps": 1000 } } })";

TEST(Schemas, ShippedScenesAreValid) {
  std::vector<Case> scenes;
  for (const auto& entry : std::filesystem::directory_iterator(source_path("scenes")))
    if (entry.path().extension() == ".json")
      scenes.push_back({entry.path().filename().string(), read_text_file(entry.path(), 1 << 20)});
  EXPECT_FALSE(scenes.empty());
  expect_valid("scene-1.schema.json", scenes);
}

TEST(Schemas, Scenes) {
  expect_valid("scene-1.schema.json", {{"the example", example_scene}});
  expect_refused(
      "scene-1.schema.json", example_scene,
      {{"an unknown key", "$", [](Json& d) { d["gravitation"] = 1; }},
       {"a radius of zero", "$.particles", [](Json& d) { d["particles"][0]["radius"] = 0; }},
       {"two ends", "$.time.end", [](Json& d) { d["time"]["end"]["time"] = 1; }},
       {"neither restitution nor damping", "$.contacts[0]",
        [](Json& d) { d["contacts"][0].erase("restitution"); }},
       {"an unknown history", "$.model.slip_history", [](Json& d) { d["model"]["slip_history"] = "none"; }},
       {"two shapes", "$.walls[0]",
        [](Json& d) { d["walls"][0]["rectangle"] = d["walls"][1]["rectangle"]; }}});
}

}  // namespace
}  // namespace warpgrain::reports
