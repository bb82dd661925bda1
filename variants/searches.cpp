#include "variants/searches.hpp"

#include <array>

#include "variants/orders.hpp"
#include "variants/plan_builder.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

void plan_cells(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, b.map(),
                          cell_ranges, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

void plan_with_list(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, b.map(),
                          cell_ranges, near, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

void list_neighbours(PlanBuilder& b) {
  b.launch(PlanBuilder::pair_unit, "list_neighbours", b.device().n_particles, b.map(), cell_ranges,
           position_radius, rank_material, near, near_counts, listed_positions, lists_outdated, status);
}
void plan_verlet(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, near,
                          near_counts, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

void plan_half_shell(PlanBuilder& b) {
  const std::size_t n = b.device().n_particles;
  b.launch(PlanBuilder::pair_unit, "clear_sums", b.device().bytes[fixed_sums] / 8, fixed_sums,
           contact_counts);
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_of_pairs", n, b.map(), cell_ranges, near,
                          b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), fixed_sums, contact_counts, status));
  b.launch(PlanBuilder::pair_unit, "force_of_sums", n, b.masses_for_weight(), fixed_sums, b.sums());
}

void list_groups(PlanBuilder& b) {
  b.launch(PlanBuilder::pair_unit, "list_groups", (b.device().n_particles + GROUP_SIZE - 1) / GROUP_SIZE,
           b.map(), cell_ranges, position_radius, rank_material, near_groups, near_counts, listed_positions,
           lists_outdated, status);
}
void plan_cluster(PlanBuilder& b) {
  b.with_history(b.launch(PlanBuilder::pair_unit, "force_between_particles", b.device().n_particles, b.map(),
                          near_groups, near_counts, near, b.particles(b.device().features.read_motion()),
                          b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

// A work-group a block of cells.
void plan_warp_per_cell(PlanBuilder& b) {
  const auto& n_cells = b.device().n_cells_along;
  const std::size_t blocks = std::size_t{(n_cells[0] + BLOCK_X - 1) / BLOCK_X} *
                             ((n_cells[1] + BLOCK_Y - 1) / BLOCK_Y) * ((n_cells[2] + BLOCK_Z - 1) / BLOCK_Z);
  b.with_history(b.launch_in_groups(
      PlanBuilder::pair_unit, "force_between_particles", blocks * CELL_WORK_GROUP, CELL_WORK_GROUP,
      b.device().parameters, b.map(), cell_ranges, near, b.particles(b.device().features.read_motion()),
      b.materials(FeatureId::pair_materials), b.sums(), contact_counts, status));
}

}  // namespace

std::span<const Search> searches() {
  static constexpr std::array<Search, 7> rows{{
      {"cells", "each work-item walks the 27 cells around its particle", "search/cells.cl", Lists::none,
       false, "force_between_particles", WorkItems::as_in_memory, nullptr, plan_cells},
      {"two_phase", "each work-item lists its contacts first, then applies the law to one after the other",
       "search/two_phase.cl", Lists::contacts, false, "force_between_particles", WorkItems::as_in_memory,
       nullptr, plan_with_list},
      {"contact_list", "the contacts of a work-group are listed, then dealt out to its work-items, one each",
       "search/contact_list.cl", Lists::contacts, false, "force_between_particles", WorkItems::as_in_memory,
       nullptr, plan_with_list},
      {"verlet", "neighbour lists with a skin, made anew when a particle has moved half of it",
       "search/verlet.cl", Lists::neighbours, false, "force_between_particles", WorkItems::as_in_memory,
       list_neighbours, plan_verlet},
      {"half_shell", "each pair once, for both its particles: integer atomics make sums that can be repeated",
       "search/half_shell.cl", Lists::contacts, true, "force_of_pairs", WorkItems::as_in_map, nullptr,
       plan_half_shell},
      {"cluster",
       "lists of groups of eight particles with a skin; the lanes of a group walk its list together",
       "search/cluster.cl", Lists::groups, false, "force_between_particles", WorkItems::as_in_map,
       list_groups, plan_cluster},
      {"warp_per_cell",
       "a warp a block of cells, whose lanes all test the candidates of the block, from local memory",
       "search/warp_per_cell.cl", Lists::contacts, false, "force_between_particles", WorkItems::of_none,
       nullptr, plan_warp_per_cell},
  }};
  return rows;
}

bool works_as_in_memory(const Variant& variant) {
  const WorkItems work_items = search_of(variant).work_items;
  const Order& order = order_of(variant);
  return work_items == WorkItems::as_in_memory ||
         (work_items == WorkItems::as_in_map && order.moves_particles && !order.by_contacts);
}

}  // namespace warpgrain
