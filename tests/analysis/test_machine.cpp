// Machine files: those that ship, and what is refused.

#include <fstream>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <string>

#include "analysis/machine.hpp"
#include "core/error.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

TEST(Machine, ShippedOnesAreRead) {
  std::vector<std::string> names;
  for (const Machine& machine : named_machines()) {
    names.push_back(machine.name);
    EXPECT_EQ(load_machine(machine.name).description, machine.description) << "the name is the file's";
    EXPECT_FALSE(machine.description.empty());
    for (const MachineKey& key : machine_keys) EXPECT_GT((machine.*key.value).source.size(), 20U) << key.key;
    EXPECT_EQ(machine.warp_width.value, 32);
  }
  EXPECT_THAT(names, testing::IsSupersetOf({"fermi_c2050", "turing_t4", "ampere_a100", "hopper_h100"}));
  EXPECT_TRUE(std::is_sorted(names.begin(), names.end()));
}

TEST(Machine, PublishedPeaksFollowFromTheNumbers) {
  // Of 32-bit floating point, a multiply-add counting two, in TFLOPS.
  const auto peak = [](const char* name) {
    const Machine m = load_machine(name);
    return m.multiprocessors.value * m.lanes.value * 2 * m.clock.value / 1e12;
  };
  EXPECT_EQ(load_machine("hopper_h100").arch, "sm_90");
  EXPECT_EQ(load_machine("fermi_c2050").arch, "") << "ptxas no longer knows it";
  EXPECT_NEAR(peak("fermi_c2050"), 1.03, 0.005);
  EXPECT_NEAR(peak("turing_t4"), 8.1, 0.05);
  EXPECT_NEAR(peak("ampere_a100"), 19.5, 0.05);
  EXPECT_NEAR(peak("hopper_h100"), 66.9, 0.05);
}

// The shipped text with one piece replaced.
std::string refusal(const std::string& piece, const std::string& by) {
  std::string text = R"({ "format": "warpgrain.machine/1", "name": "m", "description": "",
  "warp_width": { "value": 32, "source": "s" }, "multiprocessors": { "value": 2, "source": "s" },
  "lanes": { "value": 64, "source": "s" }, "sfu_lanes": { "value": 16, "source": "s" },
  "issue_rate": { "value": 0.5, "source": "s" }, "clock": { "value": 1e9, "source": "s" },
  "memory_bandwidth": { "value": 1e11, "source": "guide" } })";
  text.replace(text.find(piece), piece.size(), by);
  try {
    parse_machine(text, "m.json");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Machine, RefusesWhatIsNone) {
  EXPECT_EQ(refusal("\"m\"", "\"n\""), "no error");
  EXPECT_THAT(refusal("machine/1", "machine/2"),
              HasSubstr("m.json: format: 'warpgrain.machine/2'; expected"));
  EXPECT_THAT(refusal("\"sfu_lanes\"", "\"sfus\""), HasSubstr("m.json: "));
  EXPECT_THAT(refusal("\"value\": 16", "\"value\": 0"), HasSubstr("m.json: sfu_lanes.value: 0; expected"));
  EXPECT_THAT(refusal("\"value\": 2,", "\"value\": 2.5,"), HasSubstr("m.json: multiprocessors.value: 2.5"));
  EXPECT_THAT(refusal("0.5", "-1"), HasSubstr("m.json: issue_rate.value: -1; expected"));
  EXPECT_THAT(refusal("\"value\": 32", "\"value\": 24"), HasSubstr("m.json: warp_width: 24; expected 4, 8"));
  EXPECT_THAT(refusal("\"guide\"", "\"\""),
              HasSubstr("memory_bandwidth.source: nothing; expected the document"));
  EXPECT_THAT(refusal("1e9,", "\"fast\","), HasSubstr("m.json: clock.value: "));
  EXPECT_THAT(refusal("{ \"format\"", "{ \"watts\": 3, \"format\""), HasSubstr("watts"));
  EXPECT_EQ(refusal("\"description\": \"\"", "\"description\": \"\", \"arch\": \"sm_90a\""), "no error");
  EXPECT_THAT(refusal("\"description\": \"\"", "\"description\": \"\", \"arch\": \"hopper\""),
              HasSubstr("m.json: arch: 'hopper'; expected"));
}

TEST(Machine, CostConstantsAreAllThereOrNone) {
  EXPECT_FALSE(load_machine("fermi_c2050").cost);
  const Machine h100 = load_machine("hopper_h100");
  ASSERT_TRUE(h100.cost);
  for (const CostKey& key : cost_keys) {
    EXPECT_GT((*h100.cost.*key.value).value, 0) << key.key;
    EXPECT_GT((*h100.cost.*key.value).source.size(), 10u) << key.key;
  }
  EXPECT_THAT(refusal("{ \"format\"", R"({ "cost": { "warps": { "value": 1, "source": "s" } }, "format")"),
              HasSubstr("m.json: cost: 'work_groups' is missing"));
  EXPECT_THAT(refusal("{ \"format\"", R"({ "cost": { "warp": 1 }, "format")"), HasSubstr("m.json: cost: "));
}

TEST(Machine, UnknownNamesAreAnsweredWithThoseThatShip) {
  try {
    load_machine("c2050");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("--machine: unknown file or machine 'c2050'; valid: ampere_a100, fermi_c2050"));
  }
}

TEST(Machine, AFileOfOnesOwnWillDo) {
  const TemporaryFolder folder;
  const std::string path = (folder / "own_machine.json").string();
  std::ofstream(path) << R"({ "format": "warpgrain.machine/1", "name": "own", "description": "d",
  "warp_width": { "value": 64, "source": "s" }, "multiprocessors": { "value": 2, "source": "s" },
  "lanes": { "value": 64, "source": "s" }, "sfu_lanes": { "value": 16, "source": "s" },
  "issue_rate": { "value": 1, "source": "s" }, "clock": { "value": 1e9, "source": "s" },
  "memory_bandwidth": { "value": 1e11, "source": "s" } })";
  EXPECT_EQ(load_machine(path).warp_width.value, 64);
}

}  // namespace
}  // namespace warpgrain
