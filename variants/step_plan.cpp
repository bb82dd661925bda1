#include "variants/step_plan.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <span>

#include "kernels/layout.h"
#include "variants/contact_laws.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

class PlanBuilder {
 public:
  PlanBuilder(const Scene& scene, const Variant& variant, const DeviceScene& device,
              const KernelSources& sources)
      : variant_(variant),
        device_(device),
        sources_(sources),
        history_options_(fmt::format(" -D REAL_BITS={} -D CONTACT_SLOTS={}", device.is_fp64 ? 64 : 32,
                                     device.contact_slots)) {
    model_options_ = fmt::format(" -D SLIP_HISTORY={} -D NORMAL_FORCE={} -D ORDER_CELL={}",
                                 static_cast<int>(scene.model.slip_history),
                                 static_cast<int>(scene.model.normal_force), sorts_particles() ? 1 : 0);
  }

  StepPlan build() {
    target_ = &plan_.integrate;
    launch(unit({"integrate.cl"}, real_options()), "integrate", device_.n_particles, device_.parameters,
           position_radius, velocity_mass, angular_velocity, force, torque, status);

    target_ = &plan_.evaluate;
    if (!sorts_particles() && device_.keeps_history) {
      swap(contact_counts, contact_counts_before);
      swap(history_partners, history_partners_before);
      swap(history_displacements, history_displacements_before);
    }
    launch(unit({"map_particles.cl"}, real_options()), "map_particles", device_.n_keys, device_.parameters,
           position_radius, rank_material, cell_keys, particle_of_rank, status);
    sort();
    if (sorts_particles()) reorder();
    find_cells();
    forces();
    return std::move(plan_);
  }

 private:
  bool sorts_particles() const { return variant_.value(AxisId::order) == "cell"; }
  std::string real_options() const { return fmt::format(" -D REAL_BITS={}", device_.is_fp64 ? 64 : 32); }

  std::size_t unit(const std::vector<std::string>& files, const std::string& options) {
    plan_.units.push_back({"kernels/" + files.back(), sources_.bundle(files), "-cl-std=CL1.2" + options});
    return plan_.units.size() - 1;
  }

  static LaunchArgument argument(DeviceArray array) { return array; }
  static LaunchArgument argument(const std::vector<std::byte>& bytes) { return bytes; }
  static LaunchArgument argument(std::uint32_t value) {
    const auto bytes = std::as_bytes(std::span(&value, 1));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  }

  // One work-item an element, in work-groups of the kernels that work on particles.
  template <class... Arguments>
  KernelLaunch& launch(std::size_t unit, const char* kernel, std::size_t n_elements,
                       const Arguments&... arguments) {
    const std::size_t groups = (n_elements + PARTICLE_WORK_GROUP - 1) / PARTICLE_WORK_GROUP;
    target_->push_back(KernelLaunch{
        unit, kernel, groups * PARTICLE_WORK_GROUP, PARTICLE_WORK_GROUP, {argument(arguments)...}});
    return std::get<KernelLaunch>(target_->back());
  }

  // One work-item two keys.
  template <class... Arguments>
  void sort_launch(std::size_t unit, const char* kernel, const Arguments&... arguments) {
    target_->push_back(KernelLaunch{
        unit, kernel, device_.n_keys / 2, SORT_WORK_GROUP, {argument(cell_keys), argument(arguments)...}});
  }

  void swap(DeviceArray first, DeviceArray second) { target_->push_back(ArraySwap{first, second}); }

  void sort() {
    constexpr std::uint32_t block = 2 * SORT_WORK_GROUP;
    const std::size_t sort = unit({"sort_keys.cl"}, "");
    sort_launch(sort, "sort_blocks");
    for (std::uint32_t size = 2 * block; size <= device_.n_keys; size *= 2) {
      for (std::uint32_t stride = size / 2; stride >= block; stride /= 2)
        sort_launch(sort, "merge_stride", size, stride);
      sort_launch(sort, "merge_blocks", size);
    }
  }

  void reorder() {
    KernelLaunch& moved =
        launch(unit({"reorder_particles.cl"}, history_options_), "reorder_particles", device_.n_particles,
               device_.parameters, cell_keys, particle_of_rank, position_radius, velocity_mass,
               angular_velocity, rank_material, position_radius_spare, velocity_mass_spare,
               angular_velocity_spare, rank_material_spare);
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

  void find_cells() {
    const std::size_t cells = unit({"find_cells.cl"}, real_options());
    launch(cells, "clear_cells", device_.n_cells, device_.parameters, cell_ranges);
    launch(cells, "find_cells", device_.n_particles, device_.parameters, cell_keys, cell_ranges);
  }

  void forces() {
    const std::string law(contact_law(variant_).file);
    const std::string search = fmt::format("search/{}.cl", variant_.value(AxisId::search));
    const std::string options = history_options_ + model_options_;
    with_history(launch(unit({law, search}, options), "force_between_particles", device_.n_particles,
                        device_.parameters, cell_keys, cell_ranges, position_radius, velocity_mass,
                        angular_velocity, rank_material, contact_parameters, force, torque, contact_counts,
                        status));
    with_history(launch(unit({law, "force_from_walls.cl"}, options), "force_from_walls", device_.n_particles,
                        device_.parameters, walls, position_radius, velocity_mass, angular_velocity,
                        rank_material, contact_parameters, force, torque, contact_counts, status));
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
  const KernelSources& sources_;
  std::string history_options_, model_options_;
  StepPlan plan_;
  std::vector<PlanEntry>* target_ = nullptr;
};

}  // namespace

StepPlan make_step_plan(const Scene& scene, const Variant& variant, const DeviceScene& device,
                        const KernelSources& sources) {
  return PlanBuilder(scene, variant, device, sources).build();
}

}  // namespace warpgrain
