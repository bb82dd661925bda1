#pragma once
// The fourth level: what is left to compare once trajectories have parted. Grains flow through a slit and
// heap up, in boxes beside each other that differ by their seed.

#include <string>
#include <vector>

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

struct EnsembleQuantity {
  std::string name, unit;
  std::vector<double> values;  // [seeds]
};

// 0.8 s of `seeds` boxes of 200 grains: flow rate, kinetic energy decay (until it stays below a twentieth of
// its largest), packing fraction, coordination number, repose angle. Throws InputError as the back end does.
std::vector<EnsembleQuantity> ensemble(std::uint64_t seeds, const Backend& backend, const Variant& variant,
                                       const BackendOptions& options, double step_factor);

}  // namespace warpgrain::cli
