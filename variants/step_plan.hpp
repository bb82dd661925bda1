#pragma once
// A time step as a list of kernel launches over named arrays: the paper's flow, written once for every device
// that runs OpenCL C.

#include <cstddef>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/scene.hpp"
#include "variants/axes.hpp"
#include "variants/device_arrays.hpp"
#include "variants/device_scene.hpp"
#include "variants/kernel_sources.hpp"

namespace warpgrain {

// A text that is compiled on its own.
struct SourceUnit {
  std::string text;
  std::string build_options;  // as for clBuildProgram
};

// An array, or the bytes of a scalar or of a struct passed by value.
using LaunchArgument = std::variant<DeviceArray, std::vector<std::byte>>;

struct KernelLaunch {
  std::size_t unit = 0;  // index into StepPlan::units
  std::string kernel;
  std::size_t global_size = 0, local_size = 0;  // one-dimensional
  std::vector<LaunchArgument> arguments;
};

// Two arrays exchange their names.
struct ArraySwap {
  DeviceArray first, second;
};

using PlanEntry = std::variant<KernelLaunch, ArraySwap>;

struct StepPlan {
  std::vector<SourceUnit> units;
  std::vector<PlanEntry> integrate;
  // All that follows in the paper's flow: the forces at the present positions.
  std::vector<PlanEntry> evaluate;
};

// The launches that sort cell_keys [n_keys], ascending: n_keys is a power of two and at least 2 *
// SORT_WORK_GROUP. `unit` is that of sort_keys.cl.
std::vector<KernelLaunch> sort_launches(std::size_t unit, std::uint32_t n_keys);

StepPlan make_step_plan(const Scene& scene, const Variant& variant, const DeviceScene& device,
                        const KernelSources& sources);

}  // namespace warpgrain
