#pragma once
// One impact of two spheres, or of a sphere and a wall, run to its end.

#include "cli/probes/probe_bench.hpp"
#include "cli/probes/probe_scene.hpp"

namespace warpgrain::cli {

// Two spheres that meet along x, as far apart as their surfaces touch.
struct HeadOn {
  ProbeScene setting;                          // bodies are added here
  double speed = 1;                            // m/s, of the approach
  double radius_ratio = 1, density_ratio = 1;  // second sphere to the first, whose radius is 1 mm
  Vector3d place = Vector3d::Zero();           // of the contact [m]
  double radius = 1e-3;

  Scene scene() const;
};

// The duration of an undamped contact of particles 0 and 1, or of particle 0 and a wall [s].
double contact_time(const Scene& scene, ContactModel model, double speed);
// What the model says of the restitution of particles 0 and 1.
double expected_restitution(const Scene& scene, ContactModel model, double restitution);

struct ImpactResult {
  double restitution = 0;
  double momentum_error = 0;  // what appeared or vanished, as a part of what was exchanged
};
// Runs until the two have parted, for eight contact times at most: damped nearly to a stop, they part slower
// than can be told from not at all.
ImpactResult collide(const ProbeBench& bench, const Scene& scene, double steps_per_contact);

}  // namespace warpgrain::cli
