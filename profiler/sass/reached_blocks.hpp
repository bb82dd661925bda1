#pragma once
// Walks over what can be reached in a graph of blocks.

#include <cstdint>
#include <utility>
#include <vector>

namespace warpgrain::profiler::sass {

// Calls visit(b, go_on) once for each block that the walk comes to, `from` first; go_on(to) leads it on.
// Numbers from `n_blocks` on are no blocks and lead nowhere.
template <class Visit>
void for_each_reached(std::size_t n_blocks, std::uint32_t from, Visit&& visit) {
  std::vector<bool> seen(n_blocks, false);
  std::vector<std::uint32_t> open;
  const auto go_on = [&](std::uint32_t to) {
    if (to >= n_blocks || seen[to]) return;
    seen[to] = true;
    open.push_back(to);
  };
  go_on(from);
  while (!open.empty()) {
    const std::uint32_t b = open.back();
    open.pop_back();
    visit(b, go_on);
  }
}

}  // namespace warpgrain::profiler::sass
