#include "variants/step_plan.hpp"

#include <fmt/format.h>
#include <span>

#include "kernels/layout.h"
#include "variants/contact_laws.hpp"
#include "variants/math_modes.hpp"
#include "variants/orders.hpp"
#include "variants/plan_builder.hpp"
#include "variants/searches.hpp"
#include "variants/sorts.hpp"
#include "variants/tuning.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

// The kernels are told the options of the model by their numbers.
static_assert(static_cast<int>(SlipHistory::clip) == SLIP_HISTORY_CLIP);
static_assert(static_cast<int>(SlipHistory::paper) == SLIP_HISTORY_PAPER);
static_assert(static_cast<int>(SlipHistory::lammps) == SLIP_HISTORY_LAMMPS);
static_assert(static_cast<int>(SlipHistory::liggghts) == SLIP_HISTORY_LIGGGHTS);
static_assert(static_cast<int>(NormalForce::signed_) == NORMAL_FORCE_SIGNED);
static_assert(static_cast<int>(NormalForce::repulsive) == NORMAL_FORCE_REPULSIVE);
static_assert(wall_partner_bit == WALL_PARTNER_BIT);

std::vector<SourceUnit> source_units(const Scene& scene, const Variant& variant, const DeviceScene& device,
                                     const KernelSources& sources) {
  const std::string law(contact_law(variant).file), search(search_of(variant).file);
  const std::vector<std::string> grid_files{
      "integrate.cl",         "map_particles.cl",     std::string(sort_of(variant).file),
      "reorder_particles.cl", "order_by_contacts.cl", "point_map.cl",
      "find_cells.cl"};
  std::vector<std::string> pair_files{law, search};
  if (search_of(variant).plan_lists != nullptr) pair_files.emplace_back("search/check_lists.cl");
  const std::vector<std::string> wall_files{law, "force_from_walls.cl"};
  const SceneFeatures& features = device.features;
  std::string options =
      fmt::format("-cl-std=CL1.2 -D REAL_BITS={} -D CONTACT_SLOTS={} -D PARTICLE_WORK_GROUP={}",
                  device.is_fp64 ? 64 : 32, device.contact_slots, device.work_group);
  if (device.fixed_point) options += ' ' + device.fixed_point->build_options();
  if (device.half_history) options += ' ' + device.half_history->build_options();
  if (const auto of_subnormals = subnormal_mode(variant).build_options; !of_subnormals.empty())
    options += fmt::format(" {}", of_subnormals);
  const NormalForce normal_force =
      features.model(FeatureId::repulsion) ? scene.model.normal_force : NormalForce::signed_;
  const std::string law_options = fmt::format(
      "{} -D SLIP_HISTORY={} -D NORMAL_FORCE={} {}", options, static_cast<int>(scene.model.slip_history),
      static_cast<int>(normal_force), math_mode(variant).build_options);
  const std::string order = fmt::format("-D ORDER_CELL={} -D ORDER_MORTON={}", device.map_points ? 0 : 1,
                                        order_of(variant).has_tiles ? 1 : 0);
  std::string pair_options = fmt::format("{} {} -D LIST_SLOTS={} -D GROUP_SLOTS={}", law_options, order,
                                         device.list_slots, device.group_slots);
  if (search_of(variant).needs_long_atomics) pair_options += " -D EACH_PAIR_ONCE";
  std::vector<SourceUnit> units{
      {sources.bundle(grid_files), fmt::format("{} {}{}", options, order, features.grid_options())},
      {sources.bundle(pair_files), pair_options + features.pair_options()}};
  if (features.model_walls())
    units.push_back({sources.bundle(wall_files), law_options + features.wall_options()});
  return units;
}

void swap_history(PlanBuilder& b) {
  if (!b.device().keeps_history) return;
  b.swap(contact_counts, contact_counts_before);
  b.swap(history_partners, history_partners_before);
  b.swap(history_displacements, history_displacements_before);
}

// The history goes from "after" to "before" on the way.
void reorder(PlanBuilder& b, DeviceArray keys) {
  KernelLaunch& moved =
      b.launch(PlanBuilder::grid_unit, "reorder_particles", b.device().n_particles, keys, particle_of_rank,
               position_radius, velocity_mass, rank_material, position_radius_spare, velocity_mass_spare,
               rank_material_spare, angular_velocity, angular_velocity_spare);
  if (b.device().keeps_history) {
    for (DeviceArray array : {contact_counts, history_partners, history_displacements, contact_counts_before,
                              history_partners_before, history_displacements_before})
      moved.arguments.push_back(array);
  }
  b.swap(position_radius, position_radius_spare);
  b.swap(velocity_mass, velocity_mass_spare);
  b.swap(angular_velocity, angular_velocity_spare);
  b.swap(rank_material, rank_material_spare);
}

void plan_map(PlanBuilder& b, const Variant& variant, bool moves) {
  const std::size_t n = b.device().n_particles;
  b.launch(PlanBuilder::grid_unit, "map_particles", b.device().n_keys, position_radius, rank_material,
           cell_keys, particle_of_rank, status);
  sort_of(variant).plan_sort(b);
  if (moves && order_of(variant).by_contacts) {
    constexpr std::size_t window = 2 * ORDER_WORK_GROUP;
    b.launch_in_groups(PlanBuilder::grid_unit, "order_by_contacts",
                       (n + window - 1) / window * ORDER_WORK_GROUP, ORDER_WORK_GROUP, b.device().parameters,
                       cell_keys, particle_of_rank, contact_counts, memory_keys);
    reorder(b, memory_keys);
  } else if (moves) {
    reorder(b, cell_keys);
  } else {
    swap_history(b);
  }
  if (b.device().map_points && order_of(variant).moves_particles)
    b.launch(PlanBuilder::grid_unit, "point_map", n, particle_of_rank, cell_keys);
  sort_of(variant).plan_ranges(b);
  if (search_of(variant).plan_lists != nullptr) search_of(variant).plan_lists(b);
}

}  // namespace

LaunchArgument scalar_argument(std::uint32_t value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

StepPlan make_step_plan(const Scene& scene, const Variant& variant, const DeviceScene& device,
                        const KernelSources& sources) {
  PlanBuilder b(device);
  StepPlan& plan = b.plan();
  plan.units = source_units(scene, variant, device, sources);
  const std::size_t n = device.n_particles;

  b.begin(plan.integrate);
  b.launch(PlanBuilder::grid_unit, "integrate", n, position_radius, velocity_mass, force, status,
           angular_velocity, torque);
  b.begin(plan.map);
  plan_map(b, variant, order_of(variant).moves_particles);
  plan.maps_between_moves = reorder_interval_of(variant).maps;
  b.begin(plan.map_in_place);
  if (plan.maps_between_moves > 1) plan_map(b, variant, false);
  if (search_of(variant).plan_lists != nullptr) {
    b.begin(plan.check_map);
    b.launch(PlanBuilder::pair_unit, "check_lists", n, position_radius, rank_material, listed_positions,
             lists_outdated, status);
    b.begin(plan.keep_map);
    swap_history(b);
  }
  b.begin(plan.forces);
  search_of(variant).plan_forces(b);
  if (device.features.model_walls())
    b.with_history(b.launch(PlanBuilder::wall_unit, "force_from_walls", n, walls,
                            b.particles(device.features.read_motion_at_walls()),
                            b.materials(FeatureId::wall_materials), b.sums(), contact_counts, status));
  return std::move(plan);
}

}  // namespace warpgrain
