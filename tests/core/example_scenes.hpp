#pragma once
// Scenes for tests, written as scene files so that what they say can be read.

#include <fmt/format.h>
#include <string>

#include "core/scene.hpp"

namespace warpgrain {

struct ExampleScene {
  std::string particles = "[]";
  std::string walls = "[]";
  std::string model = "{}";
  std::string gravity = "[0, 0, 0]";
  std::string contact = R"("restitution": 0.8, "friction": 0.5)";
  std::string domain = R"({ "lower": [-1, -1, -1], "upper": [1, 1, 1] })";
  double step = 1e-6;

  std::string text() const {
    return fmt::format(R"({{ "format": "warpgrain.scene/1", "gravity": {}, "model": {},
      "materials": [ {{ "name": "glass", "density": 2500, "youngs_modulus": 1e7, "poisson_ratio": 0.3 }} ],
      "contacts": [ {{ "between": ["glass", "glass"], {} }} ],
      "particles": {}, "walls": {}, "domain": {},
      "time": {{ "step": {}, "end": {{ "steps": 1 }} }} }})",
                       gravity, model, contact, particles, walls, domain, step);
  }
  Scene scene() const { return parse_scene(text(), "example.json"); }
};

// Two spheres of 5 mm radius on the x axis, a millimetre apart, closing at `speed`.
inline ExampleScene head_on_impact(double speed, const std::string& contact) {
  ExampleScene example;
  example.particles = fmt::format(R"([
    {{ "material": "glass", "radius": 0.005, "position": [0, 0, 0], "velocity": [{0}, 0, 0] }},
    {{ "material": "glass", "radius": 0.005, "position": [0.011, 0, 0], "velocity": [-{0}, 0, 0] }} ])",
                                  speed / 2);
  example.contact = contact;
  return example;
}

// A bed of `count` spheres in a box with walls, shaken into contact with one another by its small radius of 2
// mm.
inline Scene loose_bed(std::uint64_t count, std::uint64_t seed = 1) {
  SceneOverrides overrides;
  overrides.particles = count;
  overrides.seed = seed;
  return load_scene("shear_box", overrides);
}

}  // namespace warpgrain
