#include "variants/step_plan.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <span>

#include "kernels/layout.h"
#include "variants/contact_laws.hpp"
#include "variants/math_modes.hpp"
#include "variants/orders.hpp"
#include "variants/searches.hpp"

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

LaunchArgument argument(DeviceArray array) { return array; }
LaunchArgument argument(const std::vector<std::byte>& bytes) { return bytes; }
LaunchArgument argument(std::uint32_t value) {
  const auto bytes = std::as_bytes(std::span(&value, 1));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

class PlanBuilder {
 public:
  PlanBuilder(const Scene& scene, const Variant& variant, const DeviceScene& device,
              const KernelSources& sources)
      : variant_(variant), device_(device) {
    const std::string law(contact_law(variant).file);
    const std::string search(search_of(variant).file);
    const std::vector<std::string> grid_files{"integrate.cl", "map_particles.cl", "sort_keys.cl",
                                              "reorder_particles.cl", "find_cells.cl"};
    const std::vector<std::string> pair_files{law, search}, wall_files{law, "force_from_walls.cl"};
    const std::string options = fmt::format("-cl-std=CL1.2 -D REAL_BITS={} -D CONTACT_SLOTS={}",
                                            device.is_fp64 ? 64 : 32, device.contact_slots);
    const std::string force_options = fmt::format(
        "{} -D SLIP_HISTORY={} -D NORMAL_FORCE={} {}", options, static_cast<int>(scene.model.slip_history),
        static_cast<int>(scene.model.normal_force), math_mode(variant).build_options);
    const std::string pair_options =
        fmt::format("{} -D ORDER_CELL={}", force_options, order_of(variant).moves_particles ? 1 : 0);
    plan_.units = {{sources.bundle(grid_files), options},
                   {sources.bundle(pair_files), pair_options},
                   {sources.bundle(wall_files), force_options}};
  }

  StepPlan build() {
    target_ = &plan_.integrate;
    launch(grid_unit, "integrate", device_.n_particles, device_.parameters, position_radius, velocity_mass,
           angular_velocity, force, torque, status);

    target_ = &plan_.evaluate;
    if (!order_of(variant_).moves_particles && device_.keeps_history) {
      swap(contact_counts, contact_counts_before);
      swap(history_partners, history_partners_before);
      swap(history_displacements, history_displacements_before);
    }
    launch(grid_unit, "map_particles", device_.n_keys, device_.parameters, position_radius, rank_material,
           cell_keys, particle_of_rank, status);
    for (KernelLaunch& sort : sort_launches(grid_unit, device_.n_keys)) target_->push_back(std::move(sort));
    if (order_of(variant_).moves_particles) reorder();
    launch(grid_unit, "clear_cells", device_.n_cells, device_.parameters, cell_ranges);
    launch(grid_unit, "find_cells", device_.n_particles, device_.parameters, cell_keys, cell_ranges);
    forces();
    return std::move(plan_);
  }

 private:
  // Compiled apart by what they depend on: nothing; law, search and order; the law.
  static constexpr std::size_t grid_unit = 0, pair_unit = 1, wall_unit = 2;

  // One work-item an element, in work-groups of the kernels that work on particles.
  template <class... Arguments>
  KernelLaunch& launch(std::size_t unit, const char* kernel, std::size_t n_elements,
                       const Arguments&... arguments) {
    const std::size_t groups = (n_elements + PARTICLE_WORK_GROUP - 1) / PARTICLE_WORK_GROUP;
    target_->push_back(KernelLaunch{
        unit, kernel, groups * PARTICLE_WORK_GROUP, PARTICLE_WORK_GROUP, {argument(arguments)...}});
    return std::get<KernelLaunch>(target_->back());
  }

  void swap(DeviceArray first, DeviceArray second) { target_->push_back(ArraySwap{first, second}); }

  void reorder() {
    KernelLaunch& moved =
        launch(grid_unit, "reorder_particles", device_.n_particles, device_.parameters, cell_keys,
               particle_of_rank, position_radius, velocity_mass, angular_velocity, rank_material,
               position_radius_spare, velocity_mass_spare, angular_velocity_spare, rank_material_spare);
    if (device_.keeps_history) {
      for (DeviceArray array :
           {contact_counts, history_partners, history_displacements, contact_counts_before,
            history_partners_before, history_displacements_before}) {
        moved.arguments.push_back(array);
      }
    }
    swap(position_radius, position_radius_spare);
    swap(velocity_mass, velocity_mass_spare);
    swap(angular_velocity, angular_velocity_spare);
    swap(rank_material, rank_material_spare);
  }

  void forces() {
    with_history(launch(pair_unit, "force_between_particles", device_.n_particles, device_.parameters,
                        cell_keys, cell_ranges, position_radius, velocity_mass, angular_velocity,
                        rank_material, contact_parameters, force, torque, contact_counts, status));
    with_history(launch(wall_unit, "force_from_walls", device_.n_particles, device_.parameters, walls,
                        position_radius, velocity_mass, angular_velocity, rank_material, contact_parameters,
                        force, torque, contact_counts, status));
  }

  // HISTORY_PARAMETERS of kernels/contact_history.h.
  void with_history(KernelLaunch& evaluation) const {
    if (!device_.keeps_history) return;
    for (DeviceArray array : {contact_counts_before, history_partners_before, history_displacements_before,
                              history_partners, history_displacements}) {
      evaluation.arguments.push_back(array);
    }
  }

  const Variant& variant_;
  const DeviceScene& device_;
  StepPlan plan_;
  std::vector<PlanEntry>* target_ = nullptr;
};

}  // namespace

std::vector<KernelLaunch> sort_launches(std::size_t unit, std::uint32_t n_keys) {
  constexpr std::uint32_t block = 2 * SORT_WORK_GROUP;
  std::vector<KernelLaunch> launches;
  const auto add = [&](const char* kernel, std::initializer_list<std::uint32_t> scalars) {
    launches.push_back({unit, kernel, n_keys / 2, SORT_WORK_GROUP, {cell_keys}});
    for (std::uint32_t scalar : scalars) launches.back().arguments.push_back(argument(scalar));
  };
  add("sort_blocks", {});
  for (std::uint32_t size = 2 * block; size <= n_keys; size *= 2) {
    for (std::uint32_t stride = size / 2; stride >= block; stride /= 2) add("merge_stride", {size, stride});
    add("merge_blocks", {size});
  }
  return launches;
}

StepPlan make_step_plan(const Scene& scene, const Variant& variant, const DeviceScene& device,
                        const KernelSources& sources) {
  return PlanBuilder(scene, variant, device, sources).build();
}

}  // namespace warpgrain
