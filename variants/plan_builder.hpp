#pragma once
// Builds the lists of launches of a step plan.

#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/layout.h"
#include "variants/step_plan.hpp"

namespace warpgrain {

class PlanBuilder {
 public:
  // The kernels are compiled apart by what they depend on: the order; law, search and order; the law.
  static constexpr std::size_t grid_unit = 0, pair_unit = 1, wall_unit = 2;

  explicit PlanBuilder(const DeviceScene& device) : device_(device) {}

  const DeviceScene& device() const { return device_; }
  StepPlan& plan() { return plan_; }
  // Where the entries that follow go.
  void begin(std::vector<PlanEntry>& entries) { target_ = &entries; }

  // One work-item an element, in work-groups of the kernels that work on particles. StepParameters come
  // first.
  template <class... Arguments>
  KernelLaunch& launch(std::size_t unit, const char* kernel, std::size_t n_elements,
                       const Arguments&... arguments) {
    return launch_in_groups(unit, kernel, n_elements, device_.work_group, device_.parameters, arguments...);
  }
  // The same with a work-group of its own, and without StepParameters.
  template <class... Arguments>
  KernelLaunch& launch_in_groups(std::size_t unit, const char* kernel, std::size_t n_elements,
                                 std::size_t group, const Arguments&... arguments) {
    const std::size_t groups = (n_elements + group - 1) / group;
    KernelLaunch launch{unit, kernel, groups * group, group, {}};
    (append(launch.arguments, arguments), ...);
    target_->push_back(std::move(launch));
    return std::get<KernelLaunch>(target_->back());
  }
  void add(KernelLaunch launch) { target_->push_back(std::move(launch)); }
  void swap(DeviceArray first, DeviceArray second) {
    if (device_.bytes[first] > 0) target_->push_back(ArraySwap{first, second});
  }

  // MAP_PARAMETER of kernels/grid.h: where the arrays follow the sorted map, nobody asks it.
  std::vector<DeviceArray> map() const {
    if (!device_.map_points) return {};
    return {DeviceArray::cell_keys};
  }
  // MASS_PARAMETER of kernels/search/half_shell.cl.
  std::vector<DeviceArray> masses_for_weight() const {
    if (!device_.features.model(FeatureId::gravity) || !device_.features.model(FeatureId::masses)) return {};
    return {DeviceArray::velocity_mass};
  }
  // PARTICLE_PARAMETERS, SUM_PARAMETERS and MATERIAL_PARAMETER of kernels/ in that unit.
  std::vector<DeviceArray> particles(bool reads_motion) const {
    using enum DeviceArray;
    std::vector<DeviceArray> arrays{position_radius};
    if (reads_motion) arrays.push_back(velocity_mass);
    arrays.insert(arrays.end(), {angular_velocity, rank_material});
    return arrays;
  }
  std::vector<DeviceArray> sums() const { return {DeviceArray::force, DeviceArray::torque}; }
  std::vector<DeviceArray> materials(FeatureId several) const {
    if (!device_.features.model(several)) return {};
    return {DeviceArray::contact_parameters};
  }

  // Adds HISTORY_PARAMETERS of kernels/contact_history.h.
  void with_history(KernelLaunch& evaluation) const {
    using enum DeviceArray;
    append(evaluation.arguments, {contact_counts_before, history_partners_before,
                                  history_displacements_before, history_partners, history_displacements});
  }

 private:
  // Arrays that the model does without are no arguments.
  void append(std::vector<LaunchArgument>& arguments, DeviceArray array) const {
    if (device_.bytes[array] > 0) arguments.emplace_back(array);
  }
  void append(std::vector<LaunchArgument>& arguments, const std::vector<DeviceArray>& arrays) const {
    for (const DeviceArray array : arrays) append(arguments, array);
  }
  void append(std::vector<LaunchArgument>& arguments, const std::vector<std::byte>& bytes) const {
    arguments.emplace_back(bytes);
  }
  void append(std::vector<LaunchArgument>& arguments, std::uint32_t value) const {
    arguments.push_back(scalar_argument(value));
  }

  const DeviceScene& device_;
  StepPlan plan_;
  std::vector<PlanEntry>* target_ = nullptr;
};

}  // namespace warpgrain
