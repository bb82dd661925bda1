#pragma once
// The ways to sort the map of particles and cells: one row here and one .cl file in kernels/sort/.

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "variants/axes.hpp"
#include "variants/step_plan.hpp"

namespace warpgrain {

class PlanBuilder;

struct Sort {
  std::string_view name;  // value of the axis `sort`
  std::string_view summary;
  std::string_view file;              // in kernels/
  bool needs_space;                   // keys before and after, and sums of blocks
  void (*plan_sort)(PlanBuilder&);    // adds the launches that sort cell_keys
  void (*plan_ranges)(PlanBuilder&);  // and, after the particles have been moved, those that make cell_ranges
};

std::span<const Sort> sorts();
// The sort of a variant.
const Sort& sort_of(const Variant& variant);

// The launches of the bitonic sort of cell_keys [n_keys], ascending: n_keys is a power of two and at least 2
// * SORT_WORK_GROUP. `unit` is that of sort/bitonic.cl.
std::vector<KernelLaunch> bitonic_launches(std::size_t unit, std::uint32_t n_keys);

}  // namespace warpgrain
