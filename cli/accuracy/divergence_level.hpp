#pragma once
// The third level: how long a variant's trajectories stay beside those of the double reference.

#include <optional>
#include <vector>

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

// States of the double reference at equal times, whatever a variant's step is.
struct Trajectory {
  double interval = 0;                           // s, between two states
  std::vector<std::vector<Vector3d>> positions;  // [intervals + 1][n_particles], by id
};
Trajectory reference_trajectory(const AccuracySetting& setting);

struct Divergence {
  // When the first particle is a hundredth of its radius away from where the reference has it [s]; none: not
  // within the time compared.
  std::optional<double> time;
  double compared = 0;          // s
  double root_mean_square = 0;  // distance at the end of the comparison, in radii
};
Divergence divergence(const AccuracySetting& setting, const AccuracyCase& which, const Trajectory& reference);

}  // namespace warpgrain::cli
