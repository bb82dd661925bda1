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
    target_->push_back(KernelLaunch{unit, kernel, groups * group, group, {argument(arguments)...}});
    return std::get<KernelLaunch>(target_->back());
  }
  void add(KernelLaunch launch) { target_->push_back(std::move(launch)); }
  void swap(DeviceArray first, DeviceArray second) { target_->push_back(ArraySwap{first, second}); }

  // Adds HISTORY_PARAMETERS of kernels/contact_history.h.
  void with_history(KernelLaunch& evaluation) const {
    using enum DeviceArray;
    if (!device_.keeps_history) return;
    for (DeviceArray array : {contact_counts_before, history_partners_before, history_displacements_before,
                              history_partners, history_displacements})
      evaluation.arguments.push_back(array);
  }

 private:
  static LaunchArgument argument(DeviceArray array) { return array; }
  static LaunchArgument argument(const std::vector<std::byte>& bytes) { return bytes; }
  static LaunchArgument argument(std::uint32_t value) { return scalar_argument(value); }

  const DeviceScene& device_;
  StepPlan plan_;
  std::vector<PlanEntry>* target_ = nullptr;
};

}  // namespace warpgrain
