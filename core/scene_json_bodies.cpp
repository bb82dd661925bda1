// What stands and moves in a scene file: walls and particles.

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>
#include <numeric>

#include "core/scene_fill.hpp"
#include "core/scene_json.hpp"
#include "core/state_file.hpp"

namespace warpgrain {
namespace {

Wall read_wall(const JsonReader& json, const Scene& scene) {
  json.require_keys({"material", "plane", "rectangle"});
  Wall wall;
  wall.material = material_index(json.at("material"), scene);
  const auto plane = json.maybe("plane"), rectangle = json.maybe("rectangle");
  if (plane.has_value() == rectangle.has_value()) json.fail("not one shape", "either 'plane' or 'rectangle'");
  if (plane) {
    plane->require_keys({"point", "normal"});
    wall.kind = WallKind::plane;
    wall.point = plane->at("point").vector();
    wall.normal = plane->at("normal").vector();
    if (!(wall.normal.norm() > 0)) plane->at("normal").fail("no direction", "a vector longer than 0");
    wall.normal.normalize();
    return wall;
  }
  rectangle->require_keys({"corner", "edges"});
  wall.kind = WallKind::rectangle;
  wall.point = rectangle->at("corner").vector();
  const JsonReader edges = rectangle->at("edges");
  const auto uv = edges.elements(2, "two vectors");
  wall.edge_u = uv[0].vector();
  wall.edge_v = uv[1].vector();
  wall.normal = wall.edge_u.cross(wall.edge_v);
  const double lengths = wall.edge_u.norm() * wall.edge_v.norm();
  if (!(wall.normal.norm() > 1e-9 * lengths))
    edges.fail("a wall without area", "two edges that span a rectangle");
  if (std::abs(wall.edge_u.dot(wall.edge_v)) > 1e-9 * lengths)
    edges.fail("not perpendicular", "two edges that span a rectangle");
  wall.normal.normalize();
  return wall;
}

void add_particle(Scene& scene, std::uint32_t material, double radius, const Vector3d& position,
                  const Vector3d& velocity, const Vector3d& angular_velocity) {
  ParticleState& p = scene.particles;
  p.id.push_back(static_cast<std::uint32_t>(p.id.size()));
  p.material.push_back(material);
  p.radius.push_back(radius);
  p.position.push_back(position);
  p.velocity.push_back(velocity);
  p.angular_velocity.push_back(angular_velocity);
}

void read_list(const JsonReader& json, Scene& scene) {
  const auto vector_or_zero = [](const std::optional<JsonReader>& v) {
    return v ? v->vector() : Vector3d(Vector3d::Zero());
  };
  for (const JsonReader& entry : json.elements()) {
    entry.require_keys({"material", "radius", "position", "velocity", "angular_velocity"});
    add_particle(scene, material_index(entry.at("material"), scene), entry.at("radius").number_above(0),
                 entry.at("position").vector(), vector_or_zero(entry.maybe("velocity")),
                 vector_or_zero(entry.maybe("angular_velocity")));
  }
}

void read_file(const JsonReader& json, Scene& scene) {
  json.require_keys({"file", "material", "radius"});
  std::optional<double> radius;
  if (const auto r = json.maybe("radius")) radius = r->number_above(0);
  const auto folder = std::filesystem::path(json.file()).parent_path();
  scene.particles = read_state_file(folder / json.at("file").string(), radius);
  const std::uint32_t material = material_index(json.at("material"), scene);
  scene.particles.material.assign(scene.particles.size(), material);
}

double read_fill(const JsonReader& json, const SceneOverrides& overrides, Scene& scene) {
  json.require_keys({"fill", "material"});
  const std::uint32_t material = material_index(json.at("material"), scene);
  const JsonReader fill_json = json.at("fill");
  fill_json.require_keys({"box", "count", "radius", "seed", "shear_rate"});
  const auto corners = fill_json.at("box").elements(2, "two corners");
  FillSpec fill{{corners[0].vector(), corners[1].vector()},
                fill_json.at("count").count(),
                fill_json.at("radius").number_above(0)};
  if (!((fill.box.upper - fill.box.lower).minCoeff() > 0))
    fill_json.at("box").fail("no volume", "every coordinate of the second corner above that of the first");
  if (const auto seed = fill_json.maybe("seed")) fill.seed = seed->whole_number();
  double shear_rate = 0;
  if (const auto rate = fill_json.maybe("shear_rate")) shear_rate = rate->number();

  double stretch = 1;
  if (overrides.seed) fill.seed = *overrides.seed;
  scene.seed = fill.seed;
  if (overrides.particles) {
    if (*overrides.particles == 0) fill_json.fail("0 particles asked for", "at least one");
    stretch = std::cbrt(static_cast<double>(*overrides.particles) / static_cast<double>(fill.count));
    fill.count = *overrides.particles;
    const Box box = fill.box;
    fill.box = {stretch * box.lower, stretch * box.upper};
    // Few particles: what the lattice loses by being whole cells may need a slightly larger box.
    while (!fits(fill)) {
      stretch *= 1.01;
      fill.box = {stretch * box.lower, stretch * box.upper};
    }
  }
  if (fill.count >= wall_partner_bit)
    fill_json.fail(fmt::format("{} particles", fill.count), "fewer than 2^31");
  const double middle = (fill.box.lower.z() + fill.box.upper.z()) / 2;
  for (const Vector3d& position : fill_positions(fill, fill_json.where()))
    add_particle(scene, material, fill.radius, position, Vector3d(shear_rate * (position.z() - middle), 0, 0),
                 Vector3d::Zero());
  return stretch;
}

// The direction of their contact would be undefined.
void refuse_equal_positions(const JsonReader& json, const ParticleState& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), 0);
  const auto coordinates = [&](std::size_t k) {
    return std::tuple(p.position[k].x(), p.position[k].y(), p.position[k].z(), k);
  };
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return coordinates(a) < coordinates(b); });
  for (std::size_t k = 1; k < order.size(); ++k)
    if (p.position[order[k - 1]] == p.position[order[k]])
      json.fail(
          fmt::format("particles {} and {} start at the same point", p.id[order[k - 1]], p.id[order[k]]),
          "different positions");
}

}  // namespace

void read_walls(const JsonReader& scene_json, Scene& scene) {
  const auto json = scene_json.maybe("walls");
  if (!json) return;
  for (const JsonReader& entry : json->elements()) scene.walls.push_back(read_wall(entry, scene));
}

double read_particles(const JsonReader& scene_json, const SceneOverrides& overrides, Scene& scene) {
  const JsonReader json = scene_json.at("particles");
  double stretch = 1;
  if (!json.is_array() && json.has("fill")) {
    stretch = read_fill(json, overrides, scene);
  } else {
    if (overrides.particles || overrides.seed)
      json.fail("no fill", "a scene whose particles are a 'fill', for another number of particles or seed");
    if (json.is_array())
      read_list(json, scene);
    else
      read_file(json, scene);
  }
  ParticleState& p = scene.particles;
  if (p.size() == 0) json.fail("no particles", "at least one");
  p.mass.resize(p.size());
  for (std::size_t k = 0; k < p.size(); ++k)
    p.mass[k] =
        4.0 / 3.0 * std::numbers::pi * std::pow(p.radius[k], 3) * scene.materials[p.material[k]].density;
  refuse_equal_positions(json, p);
  return stretch;
}

}  // namespace warpgrain
