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
  // What follows in the paper's flow, the forces at the present positions: first what the forces are found
  // by, the sorted map and lists made of it. Where there is a `check_map`, it runs before, and where it
  // leaves lists_outdated at zero `keep_map` takes the place of `map`.
  std::vector<PlanEntry> check_map, map, keep_map;
  // Of maps, the first of every `maps_between_moves` is `map`, which moves particles in memory, the others
  // are `map_in_place`.
  std::vector<PlanEntry> map_in_place;
  std::uint32_t maps_between_moves = 1;
  std::vector<PlanEntry> forces;
};

// A scalar as launches take it.
LaunchArgument scalar_argument(std::uint32_t value);

StepPlan make_step_plan(const Scene& scene, const Variant& variant, const DeviceScene& device,
                        const KernelSources& sources);

}  // namespace warpgrain
