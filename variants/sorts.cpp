#include "variants/sorts.hpp"

#include <array>
#include <utility>

#include "variants/plan_builder.hpp"

namespace warpgrain {
namespace {

using enum DeviceArray;

void plan_bitonic(PlanBuilder& b) {
  for (KernelLaunch& sort : bitonic_launches(PlanBuilder::grid_unit, b.device().n_keys))
    b.add(std::move(sort));
}
void plan_ranges(PlanBuilder& b) {
  b.launch(PlanBuilder::grid_unit, "clear_cells", b.device().n_cells, cell_ranges);
  b.launch(PlanBuilder::grid_unit, "find_cells", b.device().n_particles, cell_keys, cell_ranges);
}

// Cells get their ranges from the sort itself.
void no_ranges(PlanBuilder&) {}

// The scan works on blocks of cells, then on their sums, then on the blocks again.
void plan_counting(PlanBuilder& b) {
  const std::size_t n = b.device().n_particles, n_cells = b.device().n_cells;
  b.swap(cell_keys, cell_keys_spare);
  b.launch(PlanBuilder::grid_unit, "clear_cells", n_cells, cell_ranges);
  b.launch(PlanBuilder::grid_unit, "count_cells", n, cell_keys_spare, cell_ranges);
  const std::size_t blocks = (n_cells + SCAN_BLOCK - 1) / SCAN_BLOCK;
  b.launch_in_groups(PlanBuilder::grid_unit, "scan_blocks", blocks * SCAN_WORK_GROUP, SCAN_WORK_GROUP,
                     b.device().parameters, cell_ranges, scan_sums);
  b.launch_in_groups(PlanBuilder::grid_unit, "scan_sums", SCAN_WORK_GROUP, SCAN_WORK_GROUP,
                     static_cast<std::uint32_t>(blocks), scan_sums);
  b.launch(PlanBuilder::grid_unit, "place_cells", n_cells, scan_sums, cell_ranges);
  b.launch(PlanBuilder::grid_unit, "place_keys", n, cell_keys_spare, cell_ranges, cell_keys);
  b.launch(PlanBuilder::grid_unit, "sort_cells", n_cells, cell_ranges, cell_keys);
}

}  // namespace

std::vector<KernelLaunch> bitonic_launches(std::size_t unit, std::uint32_t n_keys) {
  constexpr std::uint32_t block = 2 * SORT_WORK_GROUP;
  std::vector<KernelLaunch> launches;
  const auto add = [&](const char* kernel, std::initializer_list<std::uint32_t> scalars) {
    launches.push_back({unit, kernel, n_keys / 2, SORT_WORK_GROUP, {cell_keys}});
    for (std::uint32_t scalar : scalars) launches.back().arguments.push_back(scalar_argument(scalar));
  };
  add("sort_blocks", {});
  for (std::uint32_t size = 2 * block; size <= n_keys; size *= 2) {
    for (std::uint32_t stride = size / 2; stride >= block; stride /= 2) add("merge_stride", {size, stride});
    add("merge_blocks", {size});
  }
  return launches;
}

std::span<const Sort> sorts() {
  static constexpr std::array<Sort, 2> rows{{
      {"bitonic", "the paper's: comparators in powers of two, a launch a long stride", "sort/bitonic.cl",
       false, plan_bitonic, plan_ranges},
      {"counting", "counts the particles of each cell, sums the counts and drops each particle in its place",
       "sort/counting.cl", true, plan_counting, no_ranges},
  }};
  return rows;
}

}  // namespace warpgrain
