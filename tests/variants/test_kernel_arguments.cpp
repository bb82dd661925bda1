// No kernel has an argument that it does not read: whatever a scene or a search does without, no launch
// carries.

#include <algorithm>
#include <cctype>
#include <gtest/gtest.h>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/opencl_frontend.hpp"
#include "random_bed.hpp"
#include "variants/device_scene.hpp"
#include "variants/kernel_compiler.hpp"
#include "variants/kernel_sources.hpp"
#include "variants/plan_builder.hpp"
#include "variants/searches.hpp"
#include "variants/simt_device.hpp"
#include "variants/step_plan.hpp"

namespace warpgrain {
namespace {

// Names of parameters that an entry of the PTX declares and never mentions again: "kernel_param_3".
std::set<std::string> unread_arguments(const std::string& ptx) {
  std::set<std::string> unread;
  for (std::size_t entry = ptx.find(".entry "); entry != std::string::npos;) {
    const std::size_t next = ptx.find(".entry ", entry + 1);
    const std::size_t begin = entry + std::string_view(".entry ").size(), bracket = ptx.find('(', entry);
    const std::size_t body = ptx.find(')', bracket);
    const std::string parameter = ptx.substr(begin, bracket - begin) + "_param_";
    for (std::size_t at = ptx.find(parameter, bracket); at < body; at = ptx.find(parameter, at + 1)) {
      const std::string name = ptx.substr(at, ptx.find_first_of("[,\n", at) - at);
      std::size_t use = ptx.find(name, body);
      while (use < next && std::isdigit(ptx[use + name.size()]) != 0) use = ptx.find(name, use + 1);
      if (use >= next) unread.insert(name);
    }
    entry = next;
  }
  return unread;
}

Scene of_one_kind(Scene scene) {
  std::ranges::fill(scene.particles.radius, 0.0047);
  std::ranges::fill(scene.particles.mass, 0.0011);
  std::ranges::fill(scene.particles.material, 0u);
  return scene;
}

std::vector<SourceUnit> units_of(const Scene& scene, const std::string& name) {
  const Variant variant = Variant::parse(name);
  return make_step_plan(scene, variant, lay_out(scene, variant), KernelSources()).units;
}

class KernelArguments : public testing::Test {
 protected:
  void SetUp() override {
    if (const std::string lack = simulator_lacks(); !lack.empty()) GTEST_SKIP() << lack;
  }
  const Scene rich_ = random_bed({.n_particles = 60, .seed = 4});
};

class SearchArguments : public KernelArguments, public testing::WithParamInterface<std::string> {};

void expect_all_read(const SourceUnit& unit) {
  EXPECT_EQ(unread_arguments(compile_unit(unit, KernelCompiler::clang).ptx), std::set<std::string>{});
}

// Compiling takes the time: of the searches what differs.
TEST_P(SearchArguments, AreAllRead) {
  expect_all_read(units_of(rich_, "branchy/" + GetParam() + "/cell/fp32/default").at(PlanBuilder::pair_unit));
  expect_all_read(units_of(of_one_kind(rich_), "branchy/" + GetParam() + "/unsorted/fp32/default")
                      .at(PlanBuilder::pair_unit));
}

TEST_F(KernelArguments, AreAllReadByWhatSearchesShare) {
  for (const SourceUnit& unit : units_of(rich_, "branchy/cells/cell/fp32/default")) expect_all_read(unit);
  for (const SourceUnit& unit : units_of(of_one_kind(rich_), "branchy/cells/cell/fp32/default/sort=counting"))
    expect_all_read(unit);
}

std::vector<std::string> search_names() {
  std::vector<std::string> names;
  for (const Search& search : searches()) names.emplace_back(search.name);
  return names;
}
INSTANTIATE_TEST_SUITE_P(Searches, SearchArguments, testing::ValuesIn(search_names()),
                         [](const auto& search) { return search.param; });

}  // namespace
}  // namespace warpgrain
