#include "variants/searches.hpp"

#include <array>

#include "variants/plan_builder.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

void plan_cells(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles,
                          cell_keys, cell_ranges, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

void plan_with_list(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles,
                          cell_keys, cell_ranges, near, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

// The lists themselves are made where the grid is (step_plan.cpp).
void plan_verlet(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, near,
                          near_counts, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

void plan_half_shell(PlanBuilder& b) {
  const std::size_t n = b.device().n_particles;
  b.launch(PlanBuilder::pair_unit, "clear_sums", b.device().bytes[fixed_sums] / 8, fixed_sums,
           contact_counts);
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_of_pairs", n, cell_keys, cell_ranges, near,
                          b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), fixed_sums, contact_counts, status));
  b.launch(PlanBuilder::pair_unit, "force_of_sums", n, b.particles(b.device().features.read_motion()),
           fixed_sums, b.sums());
}

}  // namespace

std::span<const Search> searches() {
  static constexpr std::array<Search, 5> rows{{
      {"cells", "each work-item walks the 27 cells around its particle", "search/cells.cl", Lists::none,
       false, plan_cells},
      {"two_phase", "each work-item lists its contacts first, then applies the law to one after the other",
       "search/two_phase.cl", Lists::contacts, false, plan_with_list},
      {"contact_list", "the contacts of a work-group are listed, then dealt out to its work-items, one each",
       "search/contact_list.cl", Lists::contacts, false, plan_with_list},
      {"verlet", "neighbour lists with a skin, made anew when a particle has moved half of it",
       "search/verlet.cl", Lists::neighbours, false, plan_verlet},
      {"half_shell", "each pair once, for both its particles: integer atomics make sums that can be repeated",
       "search/half_shell.cl", Lists::contacts, true, plan_half_shell},
  }};
  return rows;
}

}  // namespace warpgrain
