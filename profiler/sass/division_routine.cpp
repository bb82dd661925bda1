#include "profiler/sass/division_routine.hpp"

#include <algorithm>

#include "profiler/sass/reached_blocks.hpp"

namespace warpgrain::profiler::sass {

std::optional<std::vector<std::uint32_t>> find_division_guards(const CodeGraph& code, std::uint32_t entry) {
  std::vector<std::uint32_t> guards;
  for_each_reached(code.blocks.size(), entry, [&](std::uint32_t b, auto&& go_on) {
    const CodeBlock& block = code.blocks[b];
    if (block.end == End::ret || block.end == End::exit) return;
    if (block.end == End::guard) {
      guards.push_back(b);
      go_on(block.target);
    }
    go_on(block.next);
  });
  if (guards.size() != division_guards) return std::nullopt;
  std::ranges::sort(guards);
  const auto target = [&](std::size_t g) { return code.blocks[guards[g]].target; };
  const bool is_division =
      std::ranges::all_of(guards, [&](std::uint32_t b) { return code.blocks[b].guarded == Flow::branch; }) &&
      target(0) == guards[3] && target(1) == target(2) && target(1) == target(5) && target(3) > target(4) &&
      target(4) > guards[5] && code.blocks[target(1)].end == End::meet;
  return is_division ? std::optional(guards) : std::nullopt;
}

bool takes_division_guard(std::size_t guard, DivisionPath path) {
  switch (guard) {
    case 0:
      return path >= DivisionPath::nan_dividend;
    case 1:
      return path == DivisionPath::scaled;
    case 2:
      return path == DivisionPath::denormal_exact;
    case 3:
      return path == DivisionPath::nan_dividend;
    case 4:
      return path == DivisionPath::nan_divisor;
    default:
      return path == DivisionPath::undefined;
  }
}

}  // namespace warpgrain::profiler::sass
