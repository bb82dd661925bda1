#include "profiler/sass/trip_loops.hpp"

#include <algorithm>
#include <map>
#include <numeric>
#include <regex>
#include <utility>

#include "profiler/control_flow.hpp"

namespace warpgrain::profiler::sass {
namespace {

using Copies =
    std::map<std::uint32_t, std::uint32_t>;  // block of the code -> how often an instruction stands there

class Finder {
 public:
  Finder(const CodeGraph& code, const PtxDecisions& decisions, std::vector<GuardLink>& links)
      : code_(code),
        decisions_(decisions),
        links_(links),
        flow_(decisions.graph()),
        dominators_(immediate_dominators(flow_.successors(), 0)) {}

  std::vector<TripLoop> find() {
    std::vector<TripLoop> result;
    for (std::uint32_t l = 0; l < flow_.loops().size(); ++l) {
      TripLoop loop;
      loop.decision = trip_decision(flow_.loops()[l]);
      if (loop.decision == no_decision) continue;
      if (!count_copies(l, loop) || !is_unrolled(loop)) continue;
      // Copies of an inlined function may share code.
      const auto same = std::ranges::find(result, loop.decision, &TripLoop::decision);
      if (same != result.end()) {
        for (std::uint32_t b = 0; b < loop.inside.size(); ++b) {
          if (loop.inside[b]) same->inside[b] = true;
          if (loop.counts[b]) same->counts[b] = true;
        }
        continue;
      }
      find_region(loop);
      if (adopt_guards(loop)) find_region(loop);
      result.push_back(std::move(loop));
    }
    return result;
  }

 private:
  bool inside(const Loop& loop, std::uint32_t block) const {
    return std::ranges::binary_search(loop.blocks, block);
  }

  // The decision whose one way begins the next trip; of a loop that is tested at its top, that of the header.
  std::uint32_t trip_decision(const Loop& loop) const {
    const KernelGraph& graph = decisions_.graph();
    for (const std::uint32_t b : loop.blocks) {
      if (decisions_.at_end_of(b) == no_decision) continue;
      for (std::uint32_t to : graph.blocks[b].successors)
        for (std::size_t steps = 0; steps < graph.blocks.size() && inside(loop, to); ++steps) {
          if (to == loop.header) return decisions_.at_end_of(b);
          if (graph.blocks[to].successors.size() != 1) break;
          to = graph.blocks[to].successors[0];
        }
    }
    const std::uint32_t end = decisions_.way_end(loop.header);
    return end == no_block ? no_decision : decisions_.at_end_of(end);
  }

  bool runs_every_trip(std::uint32_t l, std::uint32_t block) const {
    if (flow_.loop_of()[block] != l) return false;
    const Loop& loop = flow_.loops()[l];
    return std::ranges::all_of(loop.blocks, [&](std::uint32_t from) {
      const auto& to = flow_.successors()[from];
      if (std::ranges::find(to, loop.header) == to.end()) return true;
      for (std::uint32_t at = from; at != no_block; at = dominators_[at]) {
        if (at == block) return true;
        if (at == dominators_[at]) break;
      }
      return false;
    });
  }

  // The place of the instruction in a block of the loop that runs every trip; null if it has none.
  const PtxPlace* place_in(std::uint32_t l, const Instruction& instruction) const {
    if (instruction.flow != Flow::none) return nullptr;
    for (const PtxPlace& place : decisions_.places(instruction.line))
      if (runs_every_trip(l, place.block)) return &place;
    return nullptr;
  }

  // How often each instruction that runs every trip stands in each block of the code; what most say counts.
  // Counters and addresses are reduced when a loop is unrolled: they say it in the step that they go on by.
  bool count_copies(std::uint32_t l, TripLoop& loop) const {
    const KernelGraph& graph = decisions_.graph();
    std::map<std::pair<std::uint32_t, std::uint16_t>, std::pair<Copies, std::uint32_t>> instructions;
    Copies by_steps;
    loop.copies.assign(code_.blocks.size(), 0);
    loop.predicated.assign(code_.blocks.size(), true);
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b)
      for (std::uint32_t k = code_.blocks[b].first; k < code_.blocks[b].last; ++k) {
        const Instruction& i = code_.instructions[k];
        const PtxPlace* place = place_in(l, i);
        if (place == nullptr) continue;
        auto& [copies, block] = instructions[{i.line, operation(i)}];
        ++copies[b];
        block = place->block;
        std::uint32_t& steps = by_steps[b];
        steps = std::max(steps, steps_of(i, graph.blocks[place->block].instructions[place->instruction]));
      }
    using Vote = std::pair<Copies, std::uint32_t>;
    std::map<Vote, int> votes;
    for (auto& [instruction, found] : instructions) {
      auto& [copies, block] = found;
      std::uint32_t common = 0;
      for (const auto& [at, count] : copies) common = std::gcd(common, count);
      if (copies.size() > 1)
        for (auto& [at, count] : copies) count /= common;
      votes[Vote(copies, block)] += weight(code_, instruction);
    }
    if (votes.empty()) return false;
    const auto best = std::ranges::max_element(votes, {}, [](const auto& vote) { return vote.second; });
    for (const auto& [b, count] : best->first.first) loop.copies[b] = count;
    note_predicated(l, best->first, instructions, loop);
    // A single step may stand in another block than the body that it belongs to.
    for (const auto& [b, count] : by_steps)
      if (count > 1) loop.copies[b] = std::max(loop.copies[b], count);
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b)
      if (loop.copies[b] == 0) loop.predicated[b] = false;
    loop.inside.assign(graph.blocks.size(), false);
    for (const std::uint32_t b : flow_.loops()[l].blocks) loop.inside[b] = true;
    loop.counts.assign(graph.blocks.size(), false);
    for (std::uint32_t b = 0; b < graph.blocks.size(); ++b)
      decisions_.for_run(b, [&](std::uint32_t on_run) {
        if (on_run == best->first.second) loop.counts[b] = true;
      });
    return true;
  }

  // A block makes its copies under a predicate if those that say how many there are run under one; what tests
  // and counts the trips beside them does not.
  template <class Instructions>
  void note_predicated(std::uint32_t l, const std::pair<Copies, std::uint32_t>& elected,
                       const Instructions& instructions, TripLoop& loop) const {
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b)
      for (std::uint32_t k = code_.blocks[b].first; k < code_.blocks[b].last; ++k) {
        const Instruction& i = code_.instructions[k];
        if (i.guard != always || i.instruction_class == InstructionClass::predicate) continue;
        if (place_in(l, i) != nullptr && instructions.at({i.line, operation(i)}) == elected)
          loop.predicated[b] = false;
      }
  }

  // `add.s32 %r1, %r1, 32` that became R5 = R5 + 128 makes four steps at once; 0 for what is no such counter.
  static std::uint32_t steps_of(const Instruction& instruction, const profiler::Instruction& of_ptx) {
    const bool counts = instruction.instruction_class == InstructionClass::integer &&
                        instruction.has_immediate && instruction.destination == instruction.source;
    static const std::regex add(R"(^add\.[a-z0-9]+\s+(%\w+),\s*(%\w+),\s*(-?\d+);?$)");
    std::smatch match;
    if (!counts || !std::regex_match(of_ptx.text, match, add) || match[1] != match[2]) return 0;
    const std::int64_t step = std::stoll(match[3]);
    if (step == 0 || instruction.immediate % step != 0 || instruction.immediate / step <= 0) return 0;
    return static_cast<std::uint32_t>(instruction.immediate / step);
  }

  static int weight(const CodeGraph& code, const std::pair<std::uint32_t, std::uint16_t>& instruction) {
    const auto found = std::ranges::find_if(code.instructions, [&](const Instruction& i) {
      return i.line == instruction.first && operation(i) == instruction.second;
    });
    switch (found->instruction_class) {
      case InstructionClass::global_load:
      case InstructionClass::global_store:
      case InstructionClass::shared_load:
      case InstructionClass::shared_store:
      case InstructionClass::atomic:
      case InstructionClass::special_function:
        return 4;
      case InstructionClass::fp32:
      case InstructionClass::fp64:
      case InstructionClass::conversion:
        return 3;
      default:
        return 1;
    }
  }

  // Without the form: the assembler may add a register in one copy and a number in another.
  static std::uint16_t operation(const Instruction& i) { return i.opcode & 0x1FFU; }

  bool is_trip_guard(const TripLoop& loop, std::uint32_t b) const {
    return code_.blocks[b].end == End::guard && links_[b].kind != GuardLink::Kind::fast_path &&
           links_[b].decision == loop.decision;
  }

  // Whether some way from one guard to the next makes two trips.
  bool is_unrolled(const TripLoop& loop) const {
    bool guarded = false;
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) guarded |= is_trip_guard(loop, b);
    if (!guarded) return false;
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      std::uint32_t trips = 0;
      std::uint32_t at = b;
      for (std::size_t steps = 0; at != no_code && steps < code_.blocks.size(); ++steps) {
        trips += loop.copies[at];
        const End end = code_.blocks[at].end;
        if (!goes_on(end)) break;
        at = code_.blocks[at].next;
      }
      if (trips > 1) return true;
    }
    return false;
  }

  // A guard of a decision outside the loop is not passed: so copies of the loop that an outer loop runs again
  // are no neighbours.
  bool bounds(const TripLoop& loop, std::uint32_t b) const {
    const CodeBlock& block = code_.blocks[b];
    if (block.end != End::guard) return block.end == End::indirect;
    const std::uint32_t decision = links_[b].decision;
    return decision != no_decision && links_[b].kind != GuardLink::Kind::fast_path &&
           !loop.inside[decisions_.blocks_of(decision)[0]];
  }

  void find_region(TripLoop& loop) const {
    const std::size_t n = code_.blocks.size();
    std::vector<std::vector<std::uint32_t>> successors(n), predecessors(n);
    for (std::uint32_t b = 0; b < n; ++b) {
      const CodeBlock& block = code_.blocks[b];
      if (block.end != End::exit && block.end != End::ret && block.next != no_code)
        successors[b].push_back(block.next);
      if (block.end == End::guard && block.guarded == Flow::branch) successors[b].push_back(block.target);
      for (const std::uint32_t to : successors[b]) predecessors[to].push_back(b);
    }
    const auto reached = [&](const std::vector<std::vector<std::uint32_t>>& edges) {
      std::vector<bool> seen(n, false);
      std::vector<std::uint32_t> open;
      for (std::uint32_t b = 0; b < n; ++b)
        if (loop.copies[b] != 0 || is_trip_guard(loop, b)) open.push_back(b), seen[b] = true;
      while (!open.empty()) {
        const std::uint32_t b = open.back();
        open.pop_back();
        for (const std::uint32_t to : edges[b]) {
          if (seen[to] || bounds(loop, to)) continue;
          seen[to] = true;
          open.push_back(to);
        }
      }
      return seen;
    };
    const std::vector<bool> behind = reached(successors), before = reached(predecessors);
    loop.region.assign(n, false);
    for (std::uint32_t b = 0; b < n; ++b) loop.region[b] = behind[b] && before[b];
  }

  // Where the straight way from a block ends, or first comes into the region.
  std::uint32_t landing(const TripLoop& loop, std::uint32_t b) const {
    for (std::size_t steps = 0; b != no_code && steps < code_.blocks.size(); ++steps) {
      const End end = code_.blocks[b].end;
      if (loop.region[b] || !goes_on(end)) return b;
      b = code_.blocks[b].next;
    }
    return no_code;
  }

  bool adopt_guards(const TripLoop& loop) {
    bool adopted = false;
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      const CodeBlock& block = code_.blocks[b];
      if (block.end != End::guard || block.guarded != Flow::branch || loop.region[b]) continue;
      if (links_[b].kind == GuardLink::Kind::fast_path ||
          (!repeats(b) && links_[b].kind != GuardLink::Kind::unknown))
        continue;
      const std::uint32_t taken = landing(loop, block.target), next = landing(loop, block.next);
      if (taken == no_code || next == no_code || !loop.region[taken] || !loop.region[next]) continue;
      links_[b].kind = GuardLink::Kind::unknown;
      links_[b].decision = loop.decision;
      adopted = true;
    }
    return adopted;
  }

  // Whether a guard of the same decision leads straight to this one.
  bool repeats(std::uint32_t guard) const {
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      if (b == guard || code_.blocks[b].end != End::guard || links_[b].decision != links_[guard].decision)
        continue;
      for (std::uint32_t at : {code_.blocks[b].next, code_.blocks[b].target})
        for (std::size_t steps = 0; at != no_code && steps < code_.blocks.size(); ++steps) {
          if (at == guard) return true;
          if (code_.blocks[at].end != End::next) break;
          at = code_.blocks[at].next;
        }
    }
    return false;
  }

  const CodeGraph& code_;
  const PtxDecisions& decisions_;
  std::vector<GuardLink>& links_;
  ControlFlow flow_;
  std::vector<std::uint32_t> dominators_;
};

}  // namespace

std::vector<TripLoop> find_trip_loops(const CodeGraph& code, const PtxDecisions& decisions,
                                      std::vector<GuardLink>& links) {
  return Finder(code, decisions, links).find();
}

}  // namespace warpgrain::profiler::sass
