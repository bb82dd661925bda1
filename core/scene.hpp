#pragma once
// A scene: everything a run depends on but the variant and the back end. Format "warpgrain.scene/1".

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/material.hpp"
#include "core/model.hpp"
#include "core/particle_state.hpp"
#include "core/vector3.hpp"
#include "core/wall.hpp"

namespace warpgrain {

struct Box {
  Vector3d lower = Vector3d::Zero(), upper = Vector3d::Zero();  // m
};

// When a run ends. Exactly one of the three is set.
struct RunEnd {
  struct AtRest {
    double displacement = 0;   // m: no particle has moved farther than this ...
    std::uint64_t window = 0;  // ... over this many steps
  };
  std::optional<std::uint64_t> steps;
  std::optional<double> time;  // s
  std::optional<AtRest> at_rest;
};

struct Scene {
  std::string name;
  std::string description;
  Vector3d gravity = Vector3d::Zero();  // m/s^2
  ModelOptions model;
  std::vector<Material> materials;
  ContactTable contacts;
  ParticleState particles;
  std::optional<std::uint64_t> seed;  // of the fill that the particles come from, where they do
  std::vector<Wall> walls;
  // The box of the collision grid; a particle whose centre leaves it is an error that names it. From the
  // file's "domain", else derived from particles and walls.
  Box domain;
  double time_step = 0;  // s, as given or as chosen by "auto"
  bool time_step_is_auto = false;
  RunEnd end;
};

// What the command line may change of a named or filled scene.
struct SceneOverrides {
  std::optional<std::uint64_t> particles;  // scales the fill: same material, size and shape
  std::optional<std::uint64_t> seed;
};

// Keys that a file may leave out: "name" (then the file's), "description", "gravity" (then zero), "model"
// (then the practical one with its defaults), "walls", "domain" with "lower" and "upper" (then derived:
// scene_domain.hpp), "model.simple" with "k_spring", "k_damping", "k_shear" (then derived: scene_json.hpp),
// and of a fill "seed" (then 1) and "shear_rate" [1/s], which starts each particle with v_x = shear_rate (z -
// middle of the box).

// Reads a scene file, or the named scene of that name. Throws InputError naming file and field. A file larger
// than `scene_size_limit` is refused.
Scene load_scene(std::string_view file_or_name, const SceneOverrides& overrides = {});
// The same from text; `where` stands for the file in messages and is the base of relative paths in it.
Scene parse_scene(std::string_view json_text, const std::filesystem::path& where,
                  const SceneOverrides& overrides = {});

// Names and one-line summaries of the scenes that ship, sorted.
struct SceneSummary {
  std::string name, summary;
};
std::vector<SceneSummary> named_scenes();

inline constexpr std::uintmax_t scene_size_limit = 64u << 20;  // bytes

}  // namespace warpgrain
