#include "variants/device_contents.hpp"

#include <fmt/format.h>
#include <span>
#include <unordered_map>

#include "core/error.hpp"
#include "kernels/layout.h"
#include "variants/touching_pairs.hpp"

namespace warpgrain {
namespace {

template <class T>
std::vector<std::byte> bytes_of(std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  return {bytes.begin(), bytes.end()};
}

template <class T>
std::vector<std::byte> bytes_of_one(const T& value) {
  return bytes_of(std::span<const T>(&value, 1));
}

template <class real>
layout::Triple<real> triple(const Vector3d& v) {
  return {static_cast<real>(v.x()), static_cast<real>(v.y()), static_cast<real>(v.z())};
}

// Of contacts between particles of that radius and mass, or of one with a wall, whose inverses are 0. In the
// order of kernels/pair.h and contact_law.h.
template <class real>
layout::ContactConstants<real> contact_constants(const std::vector<ContactParameters>& pairs, real radius,
                                                 real mass, real inverse_radius, real inverse_mass) {
  const ContactParameters p = pairs.empty() ? ContactParameters{} : pairs.front();
  const bool is_wall = inverse_radius == 0;
  return {.normal_parameter = static_cast<real>(p.normal_parameter),
          .tangential_parameter = static_cast<real>(p.tangential_parameter),
          .damping_parameter = static_cast<real>(p.damping_parameter),
          .friction_coefficient = static_cast<real>(p.friction_coefficient),
          .effective_radius = 1 / (1 / radius + inverse_radius),
          .effective_mass = 1 / (1 / mass + inverse_mass),
          .radius_ratio = is_wall ? 1 : (radius + radius) * inverse_radius,
          .mass_ratio = is_wall ? 1 : (mass + mass) * inverse_mass};
}

// `place` makes a triple of coordinates of a place, or of lengths.
template <class real, class Place>
auto step_parameters(const Scene& scene, const DeviceScene& device, const GridGeometry& grid, Place place) {
  const SimpleParameters& simple = scene.model.simple;
  // What particles have in common; read by kernels of scenes where they have.
  const auto time_step = static_cast<real>(scene.time_step);
  const double length = scene.particles.radius.front();
  const auto radius = static_cast<real>(
      device.fixed_point ? device.fixed_point->length(device.fixed_point->units(length)) : length);
  const auto mass = static_cast<real>(scene.particles.mass.front());
  const TouchingPairs pairs(scene);
  return layout::StepParameters<real, decltype(place(scene.domain.lower).x)>{
      .lower = place(scene.domain.lower),
      .upper = place(scene.domain.upper),
      .time_step = time_step,
      .gravity = triple<real>(scene.gravity),
      .inverse_cell_size = static_cast<real>(1 / grid.cell_edge),
      .quanta_per_force = static_cast<real>(device.quanta_per_force),
      .quanta_per_torque = static_cast<real>(device.quanta_per_torque),
      .skin = static_cast<real>(device.skin),
      .k_spring = static_cast<real>(simple.k_spring),
      .k_damping = static_cast<real>(simple.k_damping),
      .k_shear = static_cast<real>(simple.k_shear),
      .n_particles = device.n_particles,
      .n_keys = device.n_keys,
      .n_materials = static_cast<std::uint32_t>(scene.contacts.n_materials()),
      .n_walls = static_cast<std::uint32_t>(scene.walls.size()),
      .cells_x = grid.n_cells[0],
      .cells_y = grid.n_cells[1],
      .cells_z = grid.n_cells[2],
      .n_cells = device.n_cells,
      .radius = place(Vector3d::Constant(length)).x,
      .mass = mass,
      .step_per_mass = time_step / mass,
      .step_per_inertia = time_step / (static_cast<real>(0.4) * mass * radius * radius),
      .of_pairs = contact_constants<real>(pairs.of_particles, radius, mass, 1 / radius, 1 / mass),
      .of_walls = contact_constants<real>(pairs.of_walls, radius, mass, 0, 0)};
}

// Volatile, because GCC 12 drops a conversion to float and back where it vectorises.
template <class real>
Vector3d rounded(const Vector3d& v) {
  volatile real x = static_cast<real>(v.x()), y = static_cast<real>(v.y()), z = static_cast<real>(v.z());
  return {double{x}, double{y}, double{z}};
}

template <class real>
std::vector<std::byte> wall_rows(const std::vector<Wall>& walls) {
  std::vector<layout::WallLayout<real>> rows;
  for (const Wall& wall : walls) {
    layout::WallLayout<real> row{};
    row.point = triple<real>(wall.point);
    row.point_rest = static_cast<real>((wall.point - rounded<real>(wall.point)).dot(wall.normal));
    row.normal = triple<real>(wall.normal);
    row.material = wall.material;
    if (wall.kind == WallKind::rectangle) {
      row.is_rectangle = 1;
      row.edge_u = triple<real>(wall.edge_u);
      row.edge_v = triple<real>(wall.edge_v);
      row.fraction_u = triple<real>(wall.edge_u / wall.edge_u.squaredNorm());
      row.fraction_v = triple<real>(wall.edge_v / wall.edge_v.squaredNorm());
    }
    rows.push_back(row);
  }
  if (rows.empty()) rows.emplace_back();  // a buffer of no bytes cannot be made
  return bytes_of<layout::WallLayout<real>>(rows);
}

template <class real>
std::vector<std::byte> contact_parameter_rows(const ContactTable& contacts) {
  std::vector<real> rows;
  for (std::size_t i = 0; i < contacts.n_materials(); ++i) {
    for (std::size_t j = 0; j < contacts.n_materials(); ++j) {
      const ContactParameters& p = contacts.at(i, j);
      for (double value :
           {p.normal_parameter, p.tangential_parameter, p.damping_parameter, p.friction_coefficient}) {
        rows.push_back(static_cast<real>(value));
      }
    }
  }
  return bytes_of<real>(rows);
}

// x, y, z and a fourth value, a particle.
template <class real, class Fourth>
std::vector<std::byte> packed(const std::vector<Vector3d>& vectors, Fourth fourth) {
  std::vector<real> values;
  values.reserve(4 * vectors.size());
  for (std::size_t k = 0; k < vectors.size(); ++k) {
    for (int axis = 0; axis < 3; ++axis) values.push_back(static_cast<real>(vectors[k][axis]));
    values.push_back(static_cast<real>(fourth(k)));
  }
  return bytes_of<real>(values);
}

template <class real>
std::vector<std::byte> stored_as(const std::vector<Vector3d>& vectors) {
  std::vector<real> values;
  values.reserve(3 * vectors.size());
  for (const Vector3d& v : vectors)
    for (const double component : v) values.push_back(static_cast<real>(component));
  return bytes_of<real>(values);
}

template <class real>
void lay_out_history(const ParticleState& particles, DeviceScene& device) {
  const std::size_t slots = device.contact_slots;
  std::vector<std::uint32_t> counts(2 * particles.size()), partners(slots * particles.size());
  std::vector<Vector3d> displacements(slots * particles.size(), Vector3d::Zero());
  std::unordered_map<std::uint32_t, std::uint32_t> rank_of_id;
  for (std::uint32_t rank = 0; rank < particles.size(); ++rank) rank_of_id[particles.id[rank]] = rank;
  const auto rank_of = [&](std::uint32_t id) {
    const auto it = rank_of_id.find(id);
    if (it == rank_of_id.end()) {
      throw_input_error("contact history", fmt::format("particle {}", id), "an id of the scene");
    }
    return it->second;
  };
  for (const ContactRecord& record : particles.contact_history) {
    const std::uint32_t rank = rank_of(record.particle_id);
    const bool is_wall = (record.partner_id & wall_partner_bit) != 0;
    std::uint32_t& count = counts[2 * rank + (is_wall ? 1 : 0)];
    const std::size_t slot = counts[2 * rank] + counts[2 * rank + 1];
    if (slot == slots) {
      throw SimulationError(fmt::format("particle {}: its contact history has more than {} contacts",
                                        record.particle_id, slots));
    }
    partners[rank * slots + slot] = is_wall ? record.partner_id : rank_of(record.partner_id);
    if (device.half_history && !device.half_history->can_store(record.tangential_displacement))
      throw SimulationError(
          fmt::format("particle {}: its contact history has a displacement too large for half precision",
                      record.particle_id));
    displacements[rank * slots + slot] = record.tangential_displacement;
    ++count;
  }
  device.contents[DeviceArray::contact_counts] = bytes_of<std::uint32_t>(counts);
  device.contents[DeviceArray::history_partners] = bytes_of<std::uint32_t>(partners);
  device.contents[DeviceArray::history_displacements] =
      device.half_history ? device.half_history->stored(displacements) : stored_as<real>(displacements);
}

template <class real>
void fill(const Scene& scene, const GridGeometry& grid, DeviceScene& device) {
  using enum DeviceArray;
  const ParticleState& particles = scene.particles;
  auto& contents = device.contents;
  const SceneFeatures& features = device.features;
  const bool has_walls = features.model_walls();
  if (device.fixed_point) {
    device.parameters = bytes_of_one(step_parameters<real>(scene, device, grid, [&](const Vector3d& v) {
      return layout::Triple<std::int64_t>{device.fixed_point->units(v.x()), device.fixed_point->units(v.y()),
                                          device.fixed_point->units(v.z())};
    }));
    contents[position_radius] = fixed_places(particles, *device.fixed_point);
    if (has_walls) contents[walls] = fixed_wall_rows(scene.walls, *device.fixed_point);
  } else {
    device.parameters = bytes_of_one(step_parameters<real>(scene, device, grid, triple<real>));
    contents[position_radius] =
        packed<real>(particles.position, [&](std::size_t k) { return particles.radius[k]; });
    if (has_walls) contents[walls] = wall_rows<real>(scene.walls);
  }
  contents[velocity_mass] =
      packed<real>(particles.velocity, [&](std::size_t k) { return particles.mass[k]; });
  if (features.model(FeatureId::rotation))
    contents[angular_velocity] = packed<real>(particles.angular_velocity, [](std::size_t) { return 0.0; });
  std::vector<std::uint32_t> identity;
  for (std::uint32_t rank = 0; rank < particles.size(); ++rank) {
    identity.push_back(rank);
    if (features.store_materials()) identity.push_back(particles.material[rank]);
  }
  contents[rank_material] = bytes_of<std::uint32_t>(identity);
  if (features.store_materials()) contents[contact_parameters] = contact_parameter_rows<real>(scene.contacts);
  if (device.keeps_history) lay_out_history<real>(particles, device);
  std::vector<std::uint32_t> status_words(STATUS_SIZE, NO_PARTICLE);
  status_words[STATUS_STEPS] = status_words[STATUS_STOPPED] = 0;
  contents[status] = bytes_of<std::uint32_t>(status_words);
}

}  // namespace

void fill_contents(const Scene& scene, const GridGeometry& grid, DeviceScene& device) {
  if (device.is_fp64)
    fill<double>(scene, grid, device);
  else
    fill<float>(scene, grid, device);
}

}  // namespace warpgrain
