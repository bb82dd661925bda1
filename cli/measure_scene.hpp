#pragma once
// The steps of a scene on a real device: the whole step, and each of its kernels.

#include <cstdint>

#include "cli/progress.hpp"
#include "core/scene.hpp"
#include "reports/measured_report.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

struct SceneMeasurement {
  std::string backend;
  BackendOptions options;
  std::uint64_t at_step = 0;  // first that is measured
  std::uint64_t steps = 16;   // that a reading of the whole step is the mean of
  unsigned warm_up = 3, repeats = 20;
  bool mark = false;  // run one step for a profiler, and time nothing
};

// Whole steps are timed by the host's clock, in a simulation that times no kernels; kernels by the device's
// in another. Readings that `earlier` has are kept, and those that are left taken from `at_step` on; null:
// all are. When Ctrl-C has come in a command that watches for it, there are fewer readings; without any
// Interrupted is thrown. Throws what the simulation does.
reports::MeasuredReport measure_scene(const Scene& scene, const Variant& variant,
                                      const SceneMeasurement& what, const reports::MeasuredReport* earlier,
                                      Progress& progress);

}  // namespace warpgrain::cli
