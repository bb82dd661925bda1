#pragma once
// The searches for contacts: one row here and one .cl file in kernels/search/, which applies any law of
// kernels/contact/.

#include <cstdint>
#include <span>
#include <string_view>

#include "variants/axes.hpp"

namespace warpgrain {

class PlanBuilder;

// What a search lists for each particle before it applies the law.
enum class Lists : std::uint8_t {
  none,
  contacts,    // anew at every step
  neighbours,  // with a skin, until some particle has moved half of it
  groups       // the same of groups of particles; and contacts, anew at every step
};

// Which particle the work-item `i` of the kernel that applies the law is of.
enum class WorkItems : std::uint8_t {
  as_in_memory,  // the i-th of the arrays; a search that deals contacts out does so within a work-group
  as_in_map,     // the i-th of the sorted map
  of_none
};

struct Search {
  std::string_view name;  // value of the axis `search`
  std::string_view summary;
  std::string_view file;  // in kernels/
  Lists lists;
  bool needs_long_atomics;      // sums in fixed point, 64 bits
  std::string_view law_kernel;  // the one that applies the law
  WorkItems work_items;
  // Adds those that make the lists that outlive a step; null where there are none.
  void (*plan_lists)(PlanBuilder&);
  // Adds the launches that find the contacts and apply the law.
  void (*plan_forces)(PlanBuilder&);
};

std::span<const Search> searches();
// The search of a variant.
const Search& search_of(const Variant& variant);

// Whether the work-item `i` of the kernel that applies the law is of the i-th particle in memory.
bool works_as_in_memory(const Variant& variant);

}  // namespace warpgrain
