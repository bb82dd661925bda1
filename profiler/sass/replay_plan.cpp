#include "profiler/sass/replay_plan.hpp"

#include <algorithm>
#include <numeric>

#include "profiler/control_flow.hpp"
#include "profiler/sass/division_routine.hpp"

namespace warpgrain::profiler::sass {
namespace {

class Planner {
 public:
  Planner(const CodeGraph& code, const PtxDecisions& decisions)
      : code_(code), decisions_(decisions), links_(link_guards(code, decisions)) {
    plan_.loops = find_trip_loops(code, decisions, links_);
    plan_.memory = find_memory_sites(code, decisions);
    find_divisions();
  }

  ReplayPlan plan() {
    plan_.node_of.assign(code_.blocks.size(), no_code);
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      if (goes_on(code_.blocks[b].end)) continue;
      plan_.node_of[b] = static_cast<std::uint32_t>(plan_.nodes.size());
      plan_.nodes.push_back(node_at(b));
    }
    // A way may come to the end of the code, where the lane ends.
    plan_.nodes.push_back({});
    for (Node& node : plan_.nodes)
      if (&node != &plan_.nodes.back()) connect(node);
    plan_.entry = way_from(no_code, 0);
    for (Node& node : plan_.nodes)
      if (node.rule == Rule::trips) look_ahead(node);
    return std::move(plan_);
  }

 private:
  // Whether the instruction at a line of the PTX records its path.
  bool records_path(std::uint32_t line) const {
    for (const PtxPlace& place : decisions_.places(line))
      for (const MemoryAccess& access : decisions_.graph().blocks[place.block].accesses)
        if (is_path(access) && access.instruction == place.instruction) return true;
    return false;
  }

  // Guards of divisions, and those of the routines that they call.
  void find_divisions() {
    routine_guard_.assign(code_.blocks.size(), division_guards);
    is_division_.assign(code_.blocks.size(), false);
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      const CodeBlock& block = code_.blocks[b];
      if (block.end != End::guard || block.guarded != Flow::branch ||
          links_[b].kind != GuardLink::Kind::fast_path || !records_path(code_.last_of(block).line))
        continue;
      std::uint32_t call = links_[b].fast_path_taken ? block.next : block.target;
      while (code_.blocks[call].end == End::next) call = code_.blocks[call].next;
      if (code_.blocks[call].end != End::call) continue;
      const auto guards = find_division_guards(code_, code_.blocks[call].target);
      if (!guards) continue;
      is_division_[b] = true;
      for (std::size_t g = 0; g < guards->size(); ++g) routine_guard_[(*guards)[g]] = g;
    }
  }

  Node node_at(std::uint32_t b) const {
    const CodeBlock& block = code_.blocks[b];
    Node node;
    node.block = b;
    switch (block.end) {
      case End::call:
        node.rule = Rule::call;
        return node;
      case End::ret:
        node.rule = Rule::ret;
        return node;
      case End::indirect:
        node.rule = Rule::indirect;
        node.cause = node.decision = links_[b].decision;
        return node;
      case End::guard:
        break;
      default:
        return node;
    }
    const GuardLink& link = links_[b];
    node.decision = link.decision;
    node.taken_way = link.taken_way;
    node.cause = link.decision;
    node.takes_fast_path = link.fast_path_taken;
    if (is_division_[b] || routine_guard_[b] != division_guards) {
      node.rule = is_division_[b] ? Rule::path : Rule::routine;
      node.decision = no_decision;
      node.line = code_.last_of(block).line;
      node.guard = routine_guard_[b];
      return node;
    }
    for (std::uint32_t l = 0; l < plan_.loops.size(); ++l)
      if (link.kind != GuardLink::Kind::fast_path && link.decision == plan_.loops[l].decision &&
          plan_.loops[l].region[b]) {
        node.rule = Rule::trips;
        node.loop = l;
        return node;
      }
    node.rule = block.if_divergent                        ? Rule::together
                : link.kind == GuardLink::Kind::fast_path ? Rule::fast_path
                : link.kind == GuardLink::Kind::decision  ? Rule::decision
                                                          : Rule::unknown;
    return node;
  }

  void connect(Node& node) {
    const CodeBlock& block = code_.blocks[node.block];
    if (node.rule == Rule::end || node.rule == Rule::ret) return;
    if (node.rule == Rule::indirect) {
      for (const std::uint32_t to : block.table) node.table.push_back(way_from(node.block, to));
      note_table(node);
      return;
    }
    node.next = way_from(node.block, block.next);
    const bool jumps =
        node.rule == Rule::call || block.guarded == Flow::branch || block.guarded == Flow::call;
    node.taken = jumps ? way_from(node.block, block.target) : end_way();
  }

  Way end_way() const { return {static_cast<std::uint32_t>(plan_.nodes.size() - 1), {}}; }

  // From `block`, reached from `from`, to the next node.
  Way way_from(std::uint32_t from, std::uint32_t block) const {
    Way way = end_way();
    for (std::size_t steps = 0; block != no_code && steps <= code_.blocks.size(); ++steps) {
      for (std::uint32_t l = 0; l < plan_.loops.size(); ++l) {
        const TripLoop& loop = plan_.loops[l];
        if (loop.region[block] && (from == no_code || !loop.region[from]))
          way.events.push_back({l, 0, false});
        if (loop.copies[block] != 0) way.events.push_back({l, loop.copies[block], loop.predicated[block]});
      }
      if (!goes_on(code_.blocks[block].end)) {
        way.node = plan_.node_of[block];
        break;
      }
      from = block;
      block = code_.blocks[block].next;
    }
    return way;
  }

  // Each entry of the table stands for the first block of the PTX on its way that no other entry comes to
  // first; entries with the fewest blocks choose first.
  void note_table(Node& node) const {
    std::vector<std::vector<std::uint32_t>> ways;
    for (const std::uint32_t entry : code_.blocks[node.block].table) ways.push_back(blocks_on_way(entry));
    std::vector<std::uint32_t> by_length(ways.size());
    std::iota(by_length.begin(), by_length.end(), 0U);
    std::ranges::stable_sort(by_length, {}, [&](std::uint32_t k) { return ways[k].size(); });
    std::vector<std::uint32_t> entry_of(decisions_.graph().blocks.size(), no_code);
    for (const std::uint32_t k : by_length) {
      const auto free =
          std::ranges::find_if(ways[k], [&](std::uint32_t b) { return entry_of[b] == no_code; });
      if (free != ways[k].end()) entry_of[*free] = k;
    }
    node.table_of.assign(entry_of.size(), no_code);
    for (std::uint32_t b = 0; b < entry_of.size(); ++b)
      decisions_.for_run(b, [&](std::uint32_t on_run) {
        if (node.table_of[b] == no_code) node.table_of[b] = entry_of[on_run];
      });
  }

  // Blocks of the PTX whose instructions stand on the straight way from a block, in order.
  std::vector<std::uint32_t> blocks_on_way(std::uint32_t code_block) const {
    std::vector<std::uint32_t> blocks;
    for (std::size_t steps = 0; code_block != no_code && steps < code_.blocks.size(); ++steps) {
      const CodeBlock& block = code_.blocks[code_block];
      for (std::uint32_t k = block.first; k < block.last; ++k) {
        const auto& places = decisions_.places(code_.instructions[k].line);
        if (code_.instructions[k].flow == Flow::none && !places.empty() &&
            std::ranges::find(blocks, places[0].block) == blocks.end())
          blocks.push_back(places[0].block);
      }
      if (!goes_on(block.end)) {
        const auto& places = decisions_.places(code_.last_of(block).line);
        if (blocks.empty() && !places.empty()) blocks.push_back(places[0].block);
        break;
      }
      code_block = block.next;
    }
    return blocks;
  }

  void look_ahead(Node& node) const {
    node.taken_side = side_of(node.taken, node.loop);
    node.next_side = side_of(node.next, node.loop);
  }

  static std::uint32_t copies_on(const Way& way, std::uint32_t loop, bool predicated) {
    std::uint32_t copies = 0;
    for (const TripEvent& event : way.events)
      if (event.loop == loop && event.predicated == predicated) copies += event.copies;
    return copies;
  }

  bool in_region(const Node& node, std::uint32_t loop) const {
    return plan_.loops[loop].region[node.block] && node.rule != Rule::end;
  }

  TripSide side_of(const Way& way, std::uint32_t loop) const {
    std::vector<bool> seen(plan_.nodes.size(), false);
    TripSide side = nearest(way, loop, seen);
    side.most = side.copies;
    std::vector<bool> reached(plan_.nodes.size(), false);
    std::vector<std::uint32_t> open{way.node};
    while (!open.empty()) {
      const std::uint32_t n = open.back();
      open.pop_back();
      if (reached[n] || !in_region(plan_.nodes[n], loop)) continue;
      reached[n] = true;
      for (const Way* onward : ways_of(plan_.nodes[n])) {
        for (const bool predicated : {false, true}) {
          const std::uint32_t copies = copies_on(*onward, loop, predicated);
          if (!predicated) side.most = std::max(side.most, copies);
          side.unit = std::gcd(side.unit, copies);
        }
        open.push_back(onward->node);
      }
    }
    return side;
  }

  // The fewest trips up to the next guard that asks for them.
  TripSide nearest(const Way& way, std::uint32_t loop, std::vector<bool>& seen) const {
    TripSide side;
    const Node& node = plan_.nodes[way.node];
    side.leaves = !in_region(node, loop);
    if (!side.leaves && !(node.rule == Rule::trips && node.loop == loop) && !seen[way.node]) {
      seen[way.node] = true;
      bool first = true;
      for (const Way* onward : ways_of(node)) {
        const TripSide behind = nearest(*onward, loop, seen);
        if (first || behind.copies < side.copies) side.copies = behind.copies;
        side.maybe = std::max(side.maybe, behind.maybe);
        side.leaves = (first || side.leaves) && behind.leaves;
        first = false;
      }
    }
    side.copies += copies_on(way, loop, false);
    side.maybe += copies_on(way, loop, true);
    return side;
  }

  static std::vector<const Way*> ways_of(const Node& node) {
    switch (node.rule) {
      case Rule::end:
      case Rule::ret:
        return {};
      case Rule::call:
        return {&node.next};
      case Rule::fast_path:
        return {node.takes_fast_path ? &node.taken : &node.next};
      case Rule::indirect: {
        std::vector<const Way*> ways;
        for (const Way& way : node.table) ways.push_back(&way);
        return ways;
      }
      default:
        return {&node.taken, &node.next};
    }
  }

  const CodeGraph& code_;
  const PtxDecisions& decisions_;
  std::vector<GuardLink> links_;
  std::vector<bool> is_division_;           // [blocks of the code]: ends in a guard that asks for its path
  std::vector<std::size_t> routine_guard_;  // [blocks of the code]: division_guards for none of a routine
  ReplayPlan plan_;
};

}  // namespace

ReplayPlan make_plan(const CodeGraph& code, const PtxDecisions& decisions) {
  return Planner(code, decisions).plan();
}

}  // namespace warpgrain::profiler::sass
