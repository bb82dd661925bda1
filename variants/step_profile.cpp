#include "variants/step_profile.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "variants/device_simulation.hpp"
#include "variants/simt_device.hpp"

namespace warpgrain {
void require_answers(const std::vector<profiler::WhatIf>& questions,
                     const std::vector<profiler::LaunchProfile>& launches) {
  std::vector<std::string_view> labels{"thread_instructions"};
  std::set<std::string, std::less<>> answered;
  for (const profiler::LaunchProfile& launch : launches) {
    for (const profiler::WhatIfTotals& answer : launch.counters.what_if) answered.insert(answer.order);
    for (const profiler::BranchTotals& branch : launch.counters.branches)
      if (std::find(labels.begin(), labels.end(), branch.label) == labels.end())
        labels.push_back(branch.label);
  }
  labels.push_back("FILE:LINE of a line with instructions");
  for (const profiler::WhatIf& question : questions)
    if (!answered.contains(question.order.name()))
      throw_unknown_name("order sorted", "thread count", question.order.key, labels);
}

namespace {

// 0 where nothing moves, as far as anyone will see.
std::uint64_t steps_between_lists(const Scene& scene, const DeviceSimulation& simulation) {
  double fastest = 0;
  for (const Vector3d& velocity : scene.particles.velocity) fastest = std::max(fastest, velocity.norm());
  const double steps = std::ceil(simulation.listed_way() / (fastest * scene.time_step));
  return steps < 1e15 ? static_cast<std::uint64_t>(std::max(1.0, steps)) : 0;
}

}  // namespace

std::vector<profiler::LaunchProfile> profile_step(const Scene& scene, const Variant& variant,
                                                  const profiler::ProfileOptions& options,
                                                  const BackendOptions& backend,
                                                  const std::filesystem::path& export_folder,
                                                  ProfiledState* left) {
  const auto mode =
      options.addresses ? profiler::TraceMode::blocks_and_addresses : profiler::TraceMode::blocks;
  std::unique_ptr<SimtDevice> device =
      make_simt_device(mode, backend.threads, backend.compiler, options.checks);
  SimtDevice& simulator = *device;
  DeviceSimulation simulation(scene, variant, backend, std::move(device));
  profiler::ProfileOptions of_kernels = options;
  of_kernels.skip_unknown_keys = true;  // a step has many kernels, and each its own branches
  simulator.record(of_kernels, export_folder);
  simulation.step(1);
  std::vector<profiler::LaunchProfile> launches = simulator.take_profiles();
  require_answers(options.what_if, launches);
  if (left != nullptr) {
    *left = {simulation.state(), simulation.places_by_id(), {}, 0};
    left->steps_between_lists = simulation.kept_lists() ? steps_between_lists(scene, simulation) : 0;
    if (left->steps_between_lists != 0) {
      of_kernels.what_if.clear();
      of_kernels.timelines = {};
      simulator.record(of_kernels);
      simulation.renew_lists();
      left->list_launches = simulator.take_profiles();
    }
  }
  return launches;
}

}  // namespace warpgrain
