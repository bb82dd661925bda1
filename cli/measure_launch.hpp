#pragma once
// One launch file on a CUDA device.

#include <string>

#include "reports/measured_report.hpp"

namespace warpgrain::cli {

struct LaunchMeasurement {
  std::string launch, build_options;
  std::string device;                // part of its name
  std::string assembler = "driver";  // as cuda_assembler takes it
  std::string keep;                  // folder for what was assembled; empty: none
  unsigned warm_up = 3, repeats = 20;
  unsigned in_a_row = 1;  // launches of a reading
  bool check = false;     // hold the buffers against the simulator's
  bool mark = false;      // run once more, for a profiler
};

// Prints the dumped arguments to stdout. Readings that `earlier` has are kept; null: none. When Ctrl-C has
// come in a command that watches for it, there are fewer readings, and nothing is printed or checked; without
// any Interrupted is thrown. Throws InputError for a launch that cannot be run there.
reports::MeasuredReport measure_launch(const LaunchMeasurement& what, const reports::MeasuredReport* earlier);

}  // namespace warpgrain::cli
