#include "variants/device_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>
#include <span>
#include <unordered_map>

#include "core/collision_grid.hpp"
#include "core/error.hpp"
#include "kernels/layout.h"
#include "variants/contact_laws.hpp"
#include "variants/orders.hpp"
#include "variants/precisions.hpp"
#include "variants/searches.hpp"
#include "variants/sorts.hpp"
#include "variants/touching_pairs.hpp"
#include "variants/tuning.hpp"

namespace warpgrain {
namespace {

// Of neighbour lists, in largest radii: a settled bed never moves by half of it, grains that fall at 1 m/s do
// in a few steps, and wider skins list more than is won.
constexpr double skin_of_lists = 0.2;

// What every OpenCL device can hold in constant memory.
constexpr std::size_t constant_bytes = 64u << 10;

template <class T>
std::vector<std::byte> bytes_of(std::span<const T> values) {
  const auto bytes = std::as_bytes(values);
  return {bytes.begin(), bytes.end()};
}

template <class T>
std::vector<std::byte> bytes_of_one(const T& value) {
  return bytes_of(std::span<const T>(&value, 1));
}

// The cells of core's grid, with two more bounds on them. A little larger than the largest diameter: a
// particle may be rounded into the cell beside its own, and its partners must still be at most one cell away,
// which in float needs eps * cells along an axis << the margin. And not so many that a sparse scene's step is
// spent on clearing cells.
GridGeometry device_grid(const Scene& scene, double skin, double edges) {
  constexpr double margin = 1e-3, most_along_an_axis = 2048;
  const double most_cells = std::max(4096.0, 64.0 * static_cast<double>(scene.particles.size()));
  const Vector3d size = scene.domain.upper - scene.domain.lower;
  const double edge = std::max({edges * (2 * std::ranges::max(scene.particles.radius) + skin) * (1 + margin),
                                size.maxCoeff() / most_along_an_axis, std::cbrt(size.prod() / most_cells)});
  return make_grid_geometry(scene.domain, edge, scene.particles.size());
}

// In tiles of 8 x 8 x 8; no more than 8 * 8 * 8 times as many as there are cells.
std::uint32_t cells_in_tiles(const GridGeometry& grid) {
  std::uint32_t tiles = 1;
  for (const auto n : grid.n_cells) tiles *= static_cast<std::uint32_t>((n + 7) / 8);
  return 512 * tiles;
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
}

// Quanta of a force, a power of two: fixed-point sums hold 2^58 of one contact, and 2^55 is what the stiffest
// contact of the scene gives at an overlap of a radius, some 10^4 times what it gives in a settled bed.
double quanta_per_force(const Scene& scene) {
  const double radius = std::ranges::max(scene.particles.radius);
  double largest = scene.model.simple.k_spring * radius;
  for (std::size_t i = 0; i < scene.contacts.n_materials(); ++i)
    for (std::size_t j = 0; j < scene.contacts.n_materials(); ++j)
      largest = std::max(largest, scene.contacts.at(i, j).normal_parameter * radius * radius);
  return largest > 0 ? std::exp2(55 - std::ceil(std::log2(largest))) : 1;
}

void size_arrays(const Variant& variant, DeviceScene& device) {
  using enum DeviceArray;
  const std::size_t n = device.n_particles, real_bytes = device.is_fp64 ? 8 : 4;
  const bool reorders = order_of(variant).moves_particles;
  auto& bytes = device.bytes;
  for (DeviceArray vectors : {velocity_mass, force}) bytes[vectors] = 4 * real_bytes * n;
  if (device.features.model(FeatureId::rotation))
    bytes[angular_velocity] = bytes[torque] = 4 * real_bytes * n;
  bytes[position_radius] = device.contents[position_radius].size();
  bytes[rank_material] = device.contents[rank_material].size();
  bytes[contact_counts] = 8 * n;
  if (reorders) {
    bytes[position_radius_spare] = bytes[position_radius];
    bytes[velocity_mass_spare] = bytes[velocity_mass];
    bytes[angular_velocity_spare] = bytes[angular_velocity];
    bytes[rank_material_spare] = bytes[rank_material];
  }
  if (device.keeps_history) {
    bytes[contact_counts_before] = 8 * n;
    for (DeviceArray partners : {history_partners, history_partners_before})
      bytes[partners] = 4 * device.contact_slots * n;
    for (DeviceArray displacements : {history_displacements, history_displacements_before}) {
      bytes[displacements] = 3 * (device.half_history ? 2 : real_bytes) * device.contact_slots * n;
    }
  }
  bytes[cell_keys] = 8 * std::size_t{device.n_keys};
  if (sort_of(variant).needs_space) {
    bytes[cell_keys_spare] = bytes[cell_keys];
    bytes[scan_sums] = 4 * ((std::size_t{device.n_cells} + SCAN_BLOCK - 1) / SCAN_BLOCK);
  }
  if (search_of(variant).needs_long_atomics)
    bytes[fixed_sums] = 8 * n * (device.features.model(FeatureId::rotation) ? 6 : 3);
  bytes[near] = 4 * std::size_t{device.list_slots} * n;
  if (search_of(variant).lists == Lists::groups)
    bytes[near_groups] = 4 * std::size_t{device.group_slots} * ((n + GROUP_SIZE - 1) / GROUP_SIZE);
  if (search_of(variant).plan_lists != nullptr) {
    bytes[near_counts] = 4 * n;
    bytes[listed_positions] = bytes[position_radius];
    bytes[lists_outdated] = 4;
  }
  if (order_of(variant).by_contacts) bytes[memory_keys] = 8 * n;
  bytes[particle_of_rank] = 4 * n;
  bytes[cell_ranges] = 8 * std::size_t{device.n_cells};
  bytes[contact_parameters] = device.contents[contact_parameters].size();
  bytes[walls] = device.contents[walls].size();
  bytes[status] = 4 * STATUS_SIZE;
}

}  // namespace

std::size_t device_bytes(const DeviceScene& device) {
  std::size_t sum = 0;
  for (std::size_t k = 0; k < n_device_arrays; ++k) sum += device.bytes[static_cast<DeviceArray>(k)];
  return sum;
}

std::uint32_t contact_slots_for(const ParticleState& particles) {
  const auto [smallest, largest] = std::ranges::minmax(particles.radius);
  // A sphere of radius r on one of radius R covers a cap of half-angle asin(r / (R + r)); caps of one size
  // cover at most 0.9069 of a surface (the densest packing of circles). 13 for equal radii.
  const double sine = smallest / (largest + smallest);
  const double caps = 0.9069 * 2 / (1 - std::sqrt(1 - sine * sine));
  const auto needed = static_cast<std::uint32_t>(std::min(caps, 4096.0)) + 3;
  return (needed + 3) / 4 * 4;
}

std::uint32_t neighbour_slots_for(const ParticleState& particles, double skin) {
  const auto [smallest, largest] = std::ranges::minmax(particles.radius);
  // Spheres of radius r whose centres are within R + r + skin of that of a sphere of radius R lie between it
  // and a sphere of radius R + 2 r + skin, and fill 0.7405 of that at most (the densest packing of spheres);
  // half as many again for those that overlap.
  const double between = std::pow(largest + 2 * smallest + skin, 3) - std::pow(largest, 3);
  return static_cast<std::uint32_t>(std::min(1.5 * 0.7405 * between / std::pow(smallest, 3), 4096.0)) + 1;
}

DeviceScene lay_out(const Scene& scene, const Variant& variant) {
  using enum DeviceArray;
  const ParticleState& particles = scene.particles;
  if (particles.size() == 0) throw_input_error("scene: particles", "none", "at least one");
  DeviceScene device;
  device.is_fp64 = precision_of(variant).is_fp64;
  device.features = features_of(scene, variant);
  device.keeps_history = device.features.model(FeatureId::history);
  device.contact_slots = device.keeps_history ? contact_slots_for(particles) : 0;
  if (precision_of(variant).has_half_history)
    device.half_history = HalfHistory(std::ranges::min(particles.radius));
  const Lists lists = search_of(variant).lists;
  if (lists == Lists::contacts || lists == Lists::groups) device.list_slots = contact_slots_for(particles);
  if (search_of(variant).needs_long_atomics) {
    device.quanta_per_force = quanta_per_force(scene);
    device.quanta_per_torque =
        device.quanta_per_force * std::exp2(-std::ceil(std::log2(std::ranges::max(particles.radius))));
  }
  if (search_of(variant).plan_lists != nullptr)
    device.skin = skin_of_lists * std::ranges::max(particles.radius);
  if (lists == Lists::neighbours) device.list_slots = neighbour_slots_for(particles, device.skin);
  // Half as many groups as particles are near the group's, were each alone of its group.
  if (lists == Lists::groups)
    device.group_slots = GROUP_SIZE / 2 * neighbour_slots_for(particles, device.skin);
  // Kernels count in 32 bits; the largest array holds three numbers a slot.
  const std::size_t most_particles =
      (std::size_t{1} << 31) / std::max({3 * device.contact_slots, device.list_slots, 1u});
  if (particles.size() > most_particles) {
    throw_input_error("scene: particles", fmt::format("{}", particles.size()),
                      fmt::format("at most {} on a device", most_particles));
  }
  device.n_particles = static_cast<std::uint32_t>(particles.size());
  device.n_keys = std::max<std::uint32_t>(2 * SORT_WORK_GROUP, std::bit_ceil(device.n_particles));
  const GridGeometry grid = device_grid(scene, device.skin, cell_size_of(variant).edges);
  if (precision_of(variant).has_fixed_places) device.fixed_point = fixed_point_for(scene, grid.cell_edge);
  device.map_points = !order_of(variant).moves_particles || order_of(variant).by_contacts ||
                      reorder_interval_of(variant).maps > 1;
  device.work_group = work_group_of(variant).work_items;
  device.n_cells_along = grid.n_cells;
  device.n_cells =
      order_of(variant).has_tiles ? cells_in_tiles(grid) : static_cast<std::uint32_t>(grid.cell_count());
  if (device.is_fp64) {
    fill<double>(scene, grid, device);
  } else {
    fill<float>(scene, grid, device);
  }
  // The first map is made before the first evaluation.
  if (order_of(variant).by_contacts && !device.keeps_history)
    device.contents[contact_counts].assign(8 * std::size_t{device.n_particles}, std::byte{0});
  std::vector<std::uint32_t> status_words(STATUS_SIZE, NO_PARTICLE);
  status_words[STATUS_STEPS] = status_words[STATUS_STOPPED] = 0;
  device.contents[status] = bytes_of<std::uint32_t>(status_words);
  size_arrays(variant, device);
  for (const auto& [array, what] :
       {std::pair{walls, "walls"}, std::pair{contact_parameters, "pairs of materials"}}) {
    if (device.bytes[array] > constant_bytes) {
      throw_input_error("scene", fmt::format("{} of {} bytes", what, device.bytes[array]),
                        fmt::format("at most {} bytes in a device's constant memory", constant_bytes));
    }
  }
  return device;
}

}  // namespace warpgrain
