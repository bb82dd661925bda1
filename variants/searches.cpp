#include "variants/searches.hpp"

#include <array>

#include "variants/plan_builder.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

void plan_cells(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles,
                          cell_keys, cell_ranges, position_radius, velocity_mass, angular_velocity,
                          rank_material, contact_parameters, force, torque, contact_counts, status));
}

void plan_two_phase(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles,
                          cell_keys, cell_ranges, near, position_radius, velocity_mass, angular_velocity,
                          rank_material, contact_parameters, force, torque, contact_counts, status));
}

// The lists themselves are made where the grid is (step_plan.cpp).
void plan_verlet(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, near,
                          near_counts, position_radius, velocity_mass, angular_velocity, rank_material,
                          contact_parameters, force, torque, contact_counts, status));
}

}  // namespace

std::span<const Search> searches() {
  static constexpr std::array<Search, 3> rows{{
      {"cells", "each work-item walks the 27 cells around its particle", "search/cells.cl", Lists::none,
       plan_cells},
      {"two_phase", "each work-item lists its contacts first, then applies the law to one after the other",
       "search/two_phase.cl", Lists::contacts, plan_two_phase},
      {"verlet", "neighbour lists with a skin, made anew when a particle has moved half of it",
       "search/verlet.cl", Lists::neighbours, plan_verlet},
  }};
  return rows;
}

}  // namespace warpgrain
