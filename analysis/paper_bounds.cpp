#include "analysis/paper_bounds.hpp"

#include <cmath>
#include <numbers>

namespace warpgrain::paper {

double peak_ratio() { return gpu_lanes / (cpu_clock / gpu_clock) / cpu_lanes; }

double closest_packing(double volume, double diameter) {
  return std::numbers::sqrt2 * volume / (diameter * diameter * diameter);
}

double candidates() { return closest_packing(27, 1); }

double contact_share() { return most_contacts / candidates(); }

double speed_up_bound(double instructions_at_once) { return warp_width / instructions_at_once; }

double paths_bound(std::uint32_t nested_branches) { return std::exp2(nested_branches); }

double sfu_bound() { return static_cast<double>(warp_width) / sfu_lanes; }

}  // namespace warpgrain::paper
