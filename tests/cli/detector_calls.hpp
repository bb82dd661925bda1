#pragma once
// Runs that must not go on unnoticed, and what the line that ends them says: of every back end.

#include <fmt/format.h>
#include <string>
#include <vector>

#include "../core/example_scenes.hpp"

namespace warpgrain::cli {

struct DetectorCall {
  std::string what;
  ExampleScene scene;
  int steps;
  int status;                     // that the call ends with
  std::vector<std::string> says;  // parts of the line on stderr
};

inline std::string two_spheres(double radius, double distance, double speed) {
  return fmt::format(R"([
    {{ "material": "glass", "radius": {0}, "position": [0, 0, 0], "velocity": [{2}, 0, 0] }},
    {{ "material": "glass", "radius": {0}, "position": [{1}, 0, 0], "velocity": [{3}, 0, 0] }} ])",
                     radius, distance, speed / 2, -speed / 2);
}

// Two spheres each, of which the same parts of the model are needed: a back end compiles once.
inline std::vector<DetectorCall> detector_calls() {
  const auto call = [](std::string what, const std::string& particles, double step, int steps, int status,
                       std::vector<std::string> says) {
    ExampleScene scene;
    scene.particles = particles;
    scene.step = step;
    return DetectorCall{std::move(what), scene, steps, status, std::move(says)};
  };
  std::vector<DetectorCall> calls{
      call("a particle is lost", two_spheres(0.005, 0.5, -1000), 1e-4, 40, 2,
           {"step ", "particle ", "left the domain"}),
      call("an overlap beyond the model", two_spheres(0.005, 0.0101, 200), 1e-6, 200, 2,
           {"step ", "particle 0", "of its radius"}),
      call("centres coincide", two_spheres(0.005, 0, 0), 1e-6, 1, 2,
           {"particles 0 and 1 start at the same point"}),
      call("energy without a source", two_spheres(0.005, 0.01, 2), 6e-4, 20, 2,
           {"step ", "particle ", "without a source"}),
      call("a time step too large", two_spheres(0.005, 0.011, 0.01), 6e-4, 1, 0,
           {"the time step", "expected at most 0.2"}),
  };
  // Its moment of inertia is no float any more.
  calls.push_back(call("a number that is none", two_spheres(1e-12, 2.001e-12, 1), 1e-14, 400, 2,
                       {"step ", "particle ", "finite"}));
  calls.back().scene.domain = R"({ "lower": [-1e-10, -1e-10, -1e-10], "upper": [1e-10, 1e-10, 1e-10] })";
  return calls;
}

}  // namespace warpgrain::cli
