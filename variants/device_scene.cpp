#include "variants/device_scene.hpp"

#include <algorithm>
#include <bit>
#include <cmath>
#include <fmt/format.h>

#include "core/collision_grid.hpp"
#include "core/error.hpp"
#include "kernels/layout.h"
#include "variants/device_contents.hpp"
#include "variants/orders.hpp"
#include "variants/precisions.hpp"
#include "variants/searches.hpp"
#include "variants/sorts.hpp"
#include "variants/tuning.hpp"

namespace warpgrain {
namespace {

// Of neighbour lists, in largest radii: a settled bed never moves by half of it, grains that fall at 1 m/s do
// in a few steps, and wider skins list more than is won.
constexpr double skin_of_lists = 0.2;

// What every OpenCL device can hold in constant memory.
constexpr std::size_t constant_bytes = 64u << 10;

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
  fill_contents(scene, grid, device);
  // The first map is made before the first evaluation.
  if (order_of(variant).by_contacts && !device.keeps_history)
    device.contents[contact_counts].assign(8 * std::size_t{device.n_particles}, std::byte{0});
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
