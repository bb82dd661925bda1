#include "cli/accuracy/ensemble_level.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "analysis/heap.hpp"
#include "core/candidate_census.hpp"
#include "core/run_monitor.hpp"
#include "core/scene_fill.hpp"
#include "variants/contact_laws.hpp"

namespace warpgrain::cli {
namespace {

// Lengths [m]. The slit is five diameters wide, so that grains do not jam in it.
constexpr double grain_radius = 0.002, half_slit = 0.01, half_box = 0.02, depth = 0.016, fill_height = 0.06;
constexpr double floor_at = -0.04, half_floor = 0.1, ceiling = 0.08;
constexpr std::size_t grains = 200;
constexpr double duration = 0.8;  // s
constexpr int samples = 100;

std::string rectangle(const Vector3d& corner, const Vector3d& u, const Vector3d& v) {
  return fmt::format(
      R"({{"material": "soft", "rectangle": {{"corner": [{}, {}, {}], "edges": [[{}, {}, {}], [{}, {}, {}]]}}}})",
      corner.x(), corner.y(), corner.z(), u.x(), u.y(), u.z(), v.x(), v.y(), v.z());
}

std::string plane(const Vector3d& point, const Vector3d& normal) {
  return fmt::format(R"({{"material": "soft", "plane": {{"point": [{}, {}, {}], "normal": [{}, {}, {}]}}}})",
                     point.x(), point.y(), point.z(), normal.x(), normal.y(), normal.z());
}

// Softer than glass, as for large steps.
Scene boxes(std::uint64_t seeds) {
  const double length = depth * static_cast<double>(seeds);
  const Vector3d along(0, length, 0), up(0, 0, ceiling);
  std::vector<std::string> walls{plane({0, 0, floor_at}, Vector3d::UnitZ()),
                                 plane({0, 0, 0}, Vector3d::UnitY()),
                                 plane({0, length, 0}, -Vector3d::UnitY()),
                                 plane({-half_floor, 0, 0}, Vector3d::UnitX()),
                                 plane({half_floor, 0, 0}, -Vector3d::UnitX()),
                                 rectangle({-half_box, 0, 0}, {half_box - half_slit, 0, 0}, along),
                                 rectangle({half_slit, 0, 0}, {half_box - half_slit, 0, 0}, along),
                                 rectangle({-half_box, 0, 0}, along, up),
                                 rectangle({half_box, 0, 0}, along, up)};
  for (std::uint64_t k = 1; k < seeds; ++k)
    walls.push_back(rectangle({-half_floor, depth * static_cast<double>(k), floor_at}, {2 * half_floor, 0, 0},
                              {0, 0, ceiling - floor_at}));
  std::string wall_list;
  for (const std::string& wall : walls) wall_list += (wall_list.empty() ? "" : ", ") + wall;
  std::string particles;
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    const double y = depth * static_cast<double>(seed);
    const FillSpec fill{
        {{-half_box, y, 0}, {half_box, y + depth, fill_height}}, grains, grain_radius, seed + 1};
    for (const Vector3d& x : fill_positions(fill, "ensemble"))
      particles += fmt::format(R"({}{{"material": "soft", "radius": {}, "position": [{}, {}, {}]}})",
                               particles.empty() ? "" : ", ", grain_radius, x.x(), x.y(), x.z());
  }
  return parse_scene(
      fmt::format(R"({{"format": "warpgrain.scene/1", "name": "ensemble", "gravity": [0, 0, -9.81],
  "materials": [{{"name": "soft", "density": 2500, "youngs_modulus": 5e5, "poisson_ratio": 0.3}}],
  "contacts": [{{"between": ["soft", "soft"], "restitution": 0.5, "friction": 0.5}}],
  "particles": [{}], "walls": [{}],
  "domain": {{"lower": [{}, 0, {}], "upper": [{}, {}, {}]}},
  "time": {{"step": "auto", "end": {{"steps": 1}}}}}})",
                  particles, wall_list, -half_floor, floor_at, half_floor, length, ceiling),
      "ensemble");
}

// Of the box of one seed, whose particles have consecutive ids.
ParticleState part_of(const ParticleState& all, std::uint64_t seed) {
  ParticleState part;
  const auto take = [&](const auto& from, auto& to) {
    to.assign(from.begin() + static_cast<std::ptrdiff_t>(seed * grains),
              from.begin() + static_cast<std::ptrdiff_t>((seed + 1) * grains));
  };
  take(all.id, part.id);
  take(all.material, part.material);
  take(all.radius, part.radius);
  take(all.mass, part.mass);
  take(all.position, part.position);
  take(all.velocity, part.velocity);
  take(all.angular_velocity, part.angular_velocity);
  return part;
}

double kinetic_energy(const ParticleState& state) {
  double energy = 0;
  for (std::size_t k = 0; k < state.size(); ++k)
    energy += state.mass[k] * state.velocity[k].squaredNorm() / 2;
  return energy;
}

// The last time at which the energy was a twentieth of its largest.
double settling_time(const std::vector<double>& energies, double interval) {
  const double limit = *std::ranges::max_element(energies) / 20;
  std::size_t last = 0;
  for (std::size_t k = 0; k < energies.size(); ++k)
    if (energies[k] > limit) last = k;
  return interval * static_cast<double>(last);
}

}  // namespace

std::vector<EnsembleQuantity> ensemble(std::uint64_t seeds, const Backend& backend, const Variant& variant,
                                       const BackendOptions& options, double step_factor) {
  Scene scene = with_step(boxes(seeds), step_factor);
  scene.model.contact = contact_law(variant).model;
  RunMonitor monitor(scene);
  const auto simulation = backend.create(scene, variant, options);
  const auto chunk = static_cast<std::uint64_t>(std::ceil(duration / samples / scene.time_step));
  const double interval = static_cast<double>(chunk) * scene.time_step;
  std::vector<std::vector<PassedAt>> passed(seeds);
  std::vector<std::vector<double>> energies(seeds);
  ParticleState state = scene.particles;
  for (int k = 0; k <= samples; ++k) {
    if (k > 0) simulation->step(chunk);
    state = simulation->state();
    monitor.look(simulation->steps_done(), state);
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const ParticleState part = part_of(state, seed);
      const auto below = std::ranges::count_if(part.position, [](const Vector3d& x) { return x.z() < 0; });
      passed[seed].push_back({interval * k, static_cast<double>(below)});
      energies[seed].push_back(kinetic_energy(part));
    }
  }
  std::vector<EnsembleQuantity> quantities{{"flow rate", "grains/s", {}},
                                           {"kinetic energy decay", "s", {}},
                                           {"packing fraction", "", {}},
                                           {"coordination number", "", {}},
                                           {"repose angle", "degrees", {}}};
  for (std::uint64_t seed = 0; seed < seeds; ++seed) {
    Scene fallen = scene;
    fallen.particles = part_of(state, seed);
    const auto& positions = fallen.particles.position;
    std::vector<Vector3d> heap;
    for (const Vector3d& x : positions)
      if (x.z() < 0) heap.push_back(x);
    const double y = depth * static_cast<double>(seed);
    quantities[0].values.push_back(flow_rate(passed[seed], 0.1 * grains, 0.4 * grains));
    quantities[1].values.push_back(settling_time(energies[seed], interval));
    quantities[2].values.push_back(packing_fraction(heap, grain_radius, {-half_slit, y, floor_at},
                                                    {half_slit, y + depth, floor_at + 4 * grain_radius}));
    quantities[3].values.push_back(candidate_census(fallen).mean_contacts);
    quantities[4].values.push_back(repose_angle(heap, grain_radius, floor_at));
  }
  return quantities;
}

}  // namespace warpgrain::cli
