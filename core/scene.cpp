#include "core/scene.hpp"

#include <fmt/format.h>

#include "core/embedded_scenes.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "core/scene_domain.hpp"
#include "core/scene_json.hpp"
#include "core/time_step_advice.hpp"

namespace warpgrain {
namespace {

constexpr std::string_view scene_format = "warpgrain.scene/1";

// "slit" for "slit.json"
std::string_view scene_name(const EmbeddedScene& scene) {
  return scene.path.substr(0, scene.path.rfind('.'));
}

void stretch_lengths(Scene& scene, double factor) {
  for (Wall& wall : scene.walls) {
    wall.point *= factor;
    wall.edge_u *= factor;
    wall.edge_v *= factor;
  }
  scene.domain.lower *= factor;
  scene.domain.upper *= factor;
}

void require_particles_inside(const JsonReader& json, const Scene& scene) {
  for (std::size_t k = 0; k < scene.particles.size(); ++k) {
    const Vector3d& x = scene.particles.position[k];
    const bool inside =
        (x.array() >= scene.domain.lower.array()).all() && (x.array() <= scene.domain.upper.array()).all();
    if (!inside)
      json.at("particles")
          .fail(fmt::format("particle {} at ({}, {}, {}) outside of the domain", scene.particles.id[k], x.x(),
                            x.y(), x.z()),
                fmt::format("a place between ({}, {}, {}) and ({}, {}, {})", scene.domain.lower.x(),
                            scene.domain.lower.y(), scene.domain.lower.z(), scene.domain.upper.x(),
                            scene.domain.upper.y(), scene.domain.upper.z()));
  }
}

}  // namespace

Scene parse_scene(std::string_view json_text, const std::filesystem::path& where,
                  const SceneOverrides& overrides) {
  if (json_text.size() > scene_size_limit)
    throw_input_error(where.string(), fmt::format("{} bytes", json_text.size()),
                      fmt::format("at most {} bytes", scene_size_limit));
  const JsonReader json = JsonReader::parse(json_text, where.string());
  json.require_keys({"format", "name", "description", "gravity", "model", "materials", "contacts",
                     "particles", "walls", "domain", "time"});
  const JsonReader format = json.at("format");
  if (format.string() != scene_format)
    format.fail("'" + format.string() + "'", fmt::format("'{}'", scene_format));

  Scene scene;
  scene.name = where.stem().string();
  if (const auto name = json.maybe("name")) scene.name = name->string();
  if (const auto description = json.maybe("description")) scene.description = description->string();
  if (const auto gravity = json.maybe("gravity")) scene.gravity = gravity->vector();
  read_model(json, scene);
  read_materials(json, scene);
  const double stretch = read_particles(json, overrides, scene);
  read_walls(json, scene);
  read_domain(json, scene);
  stretch_lengths(scene, stretch);
  read_contacts(json, scene);
  read_time(json, scene);
  if (scene.time_step_is_auto) scene.time_step = advise_time_step(scene, time_step_limits(scene)).step;
  if (!json.has("domain")) scene.domain = derive_domain(scene);
  require_particles_inside(json, scene);
  return scene;
}

Scene load_scene(std::string_view file_or_name, const SceneOverrides& overrides) {
  for (const EmbeddedScene& scene : embedded_scenes())
    if (scene_name(scene) == file_or_name)
      return parse_scene(scene.text, fmt::format("scenes/{}", scene.path), overrides);
  const std::filesystem::path file(file_or_name);
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) {
    std::vector<std::string_view> names;
    for (const EmbeddedScene& scene : embedded_scenes()) names.push_back(scene_name(scene));
    throw_unknown_name("scene", "file or name", file_or_name, names);
  }
  return parse_scene(read_text_file(file, scene_size_limit), file, overrides);
}

std::vector<SceneSummary> named_scenes() {
  std::vector<SceneSummary> summaries;
  for (const EmbeddedScene& scene : embedded_scenes()) {
    const std::string description = JsonReader::parse(scene.text, scene.path).at("description").string();
    summaries.push_back({std::string(scene_name(scene)), description.substr(0, description.find(". "))});
  }
  return summaries;
}

}  // namespace warpgrain
