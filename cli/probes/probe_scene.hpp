#pragma once
// The small scenes of the probes, written as scene files are and read by the same reader: what a probe says
// of a scene holds for a user's file with the same numbers.

#include <string>
#include <vector>

#include "core/scene.hpp"

namespace warpgrain::cli {

inline constexpr double probe_radius = 1e-3;  // m, of bodies where a probe does not vary it

struct ProbeMaterial {
  double density = 2500;        // kg/m^3
  double youngs_modulus = 1e7;  // Pa
};

struct ProbeBody {
  double radius = probe_radius;  // m
  Vector3d position = Vector3d::Zero(), velocity = Vector3d::Zero();
  std::size_t material = 0;
};

struct ProbePlane {
  Vector3d point = Vector3d::Zero(), normal = Vector3d::UnitZ();
};

struct ProbeScene {
  std::vector<ProbeMaterial> materials{{}};
  double restitution = 0.8, friction = 0.5;  // of every pair
  std::vector<ProbeBody> bodies;
  std::vector<ProbePlane> planes;
  Vector3d gravity = Vector3d::Zero();
  std::string slip_history = "clip";
  double room = 10;  // from the bodies to the ends of the domain, in largest radii

  std::string json() const;  // "warpgrain.scene/1", its step "auto"
  // Throws InputError as parse_scene does. The step is the automatic one until the probe sets its own.
  Scene scene() const;
};

}  // namespace warpgrain::cli
