#include "profiler/sass/guard_links.hpp"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>

#include "profiler/control_flow.hpp"
#include "profiler/sass/reached_blocks.hpp"

namespace warpgrain::profiler::sass {
namespace {

using LineCounts = std::unordered_map<std::uint32_t, int>;
using LineSet = std::unordered_set<std::uint32_t>;

bool is_plain(const Instruction& i) { return i.flow == Flow::none && mnemonic(i) != "NOP"; }

class Linker {
 public:
  Linker(const CodeGraph& code, const PtxDecisions& decisions) : code_(code), decisions_(decisions) {}

  std::vector<GuardLink> link() {
    links_.resize(code_.blocks.size());
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b) {
      if (code_.blocks[b].end != End::guard && code_.blocks[b].end != End::indirect) continue;
      const std::vector<std::uint32_t> near = near_decisions(code_.last_of(code_.blocks[b]).line);
      if (near.empty()) continue;
      links_[b].decision = near.front();
      guarded_.insert(near.front());
    }
    for (std::uint32_t b = 0; b < code_.blocks.size(); ++b)
      if (code_.blocks[b].end == End::guard) orient(b);
    return std::move(links_);
  }

 private:
  // Decisions that a guard with that line may carry out, the likeliest first: the one at the end of the
  // instruction's block, the one that led there, the one that the block goes on to.
  std::vector<std::uint32_t> near_decisions(std::uint32_t line) const {
    const std::vector<PtxPlace>& places = decisions_.places(line);
    if (places.empty()) return {};
    const std::uint32_t b = places[0].block;
    if (decisions_.at_end_of(b) != no_decision) return {decisions_.at_end_of(b)};
    std::vector<std::uint32_t> found;
    const BasicBlock& block = decisions_.graph().blocks[b];
    const bool jumps = places[0].instruction + 1 == block.instructions.size() &&
                       block.instructions.back().instruction_class == InstructionClass::branch;
    if (jumps && decisions_.decided_by(b) != no_block)
      found.push_back(decisions_.at_end_of(decisions_.decided_by(b)));
    if (decisions_.way_end(b) != no_block) found.push_back(decisions_.at_end_of(decisions_.way_end(b)));
    return found;
  }

  // Whether the guard's line is that of its decision's own instruction.
  bool stands_at_decision(std::uint32_t b) const {
    const std::uint32_t line = code_.last_of(code_.blocks[b]).line;
    for (const PtxPlace& place : decisions_.places(line)) {
      const BasicBlock& block = decisions_.graph().blocks[place.block];
      if (block.successors.size() > 1 && place.instruction + 1 == block.instructions.size()) return true;
    }
    return false;
  }

  void orient(std::uint32_t b) {
    const CodeBlock& block = code_.blocks[b];
    GuardLink& link = links_[b];
    if (!stands_at_decision(b) && find_fast_path(block, link)) return;
    if (is_retry_of_atomic(block)) return;
    const std::vector<std::uint32_t> near = near_decisions(code_.last_of(block).line);
    for (const bool far : {false, true})
      for (const std::uint32_t decision : near) {
        const std::uint32_t of = decisions_.blocks_of(decision)[0];
        const std::vector<std::uint32_t>& ways = decisions_.graph().blocks[of].successors;
        if (ways.size() != 2) continue;
        const int votes = far ? far_votes(b, of, ways) : near_votes(b, of, ways);
        if (votes == 0) continue;
        link = {GuardLink::Kind::decision, decision, votes > 0 ? 0U : 1U, false};
        return;
      }
  }

  // Where lanes go that take the guard; no_code for those that end.
  std::uint32_t taken_side(const CodeBlock& block) const {
    return block.guarded == Flow::branch ? block.target : no_code;
  }

  // A routine for rare operands is called on one side, before the sides meet.
  bool find_fast_path(const CodeBlock& block, GuardLink& link) const {
    if (block.guarded == Flow::call) {
      link.kind = GuardLink::Kind::fast_path;
      link.fast_path_taken = false;
      return true;
    }
    if (block.guarded != Flow::branch) return false;
    const bool taken_calls = calls_routine(block.target), next_calls = calls_routine(block.next);
    if (taken_calls == next_calls) return false;
    link.kind = GuardLink::Kind::fast_path;
    link.fast_path_taken = next_calls;
    return true;
  }

  // Whether the straight way from a block makes a call.
  bool calls_routine(std::uint32_t b) const {
    for (std::size_t steps = 0; b != no_code && steps < code_.blocks.size(); ++steps) {
      if (code_.blocks[b].end == End::call) return true;
      if (code_.blocks[b].end != End::next) return false;
      b = code_.blocks[b].next;
    }
    return false;
  }

  // Some atomic operations are loops that try until no other lane has come between.
  bool is_retry_of_atomic(const CodeBlock& block) const {
    const std::uint32_t line = code_.last_of(block).line;
    for (const PtxPlace& place : decisions_.places(line))
      if (decisions_.graph().blocks[place.block].instructions[place.instruction].instruction_class ==
          InstructionClass::atomic)
        return true;
    return false;
  }

  // Instructions by line on the straight way from a block to the next guard; the guard speaks for its
  // decision's block.
  LineCounts lines_on_way(std::uint32_t b) const {
    LineCounts lines;
    for (std::size_t steps = 0; b != no_code && steps < code_.blocks.size(); ++steps) {
      const CodeBlock& block = code_.blocks[b];
      for (std::uint32_t k = block.first; k < block.last; ++k)
        if (is_plain(code_.instructions[k])) ++lines[code_.instructions[k].line];
      constexpr int weight_of_guard = 6;
      if (block.end == End::guard) lines[code_.last_of(block).line] += weight_of_guard;
      if (block.end == End::guard || block.end == End::indirect || block.end == End::exit ||
          block.end == End::ret)
        break;
      b = block.next;
    }
    return lines;
  }

  // Lines of the blocks from `from` on, up to those whose decisions have guards of their own.
  LineSet lines_from(std::uint32_t from, std::uint32_t but, bool stops_at_guards) const {
    const KernelGraph& graph = decisions_.graph();
    LineSet lines;
    for_each_reached(graph.blocks.size(), from, [&](std::uint32_t b, auto&& go_on) {
      for (const profiler::Instruction& i : graph.blocks[b].instructions) lines.insert(i.ptx_line);
      const std::uint32_t decision = decisions_.at_end_of(b);
      if (decision == but) return;
      if (stops_at_guards && decision != no_decision && guarded_.contains(decision)) return;
      for (const std::uint32_t to : graph.blocks[b].successors) go_on(to);
    });
    return lines;
  }

  // Above 0: lanes that take the guard went the first way.
  int count_votes(const CodeBlock& block, const LineCounts& taken, const LineCounts& next,
                  const LineSet& first, const LineSet& second, const std::vector<std::uint32_t>& ways) const {
    int votes = 0;
    const auto add = [&](const LineCounts& counts, int sign) {
      for (const auto& [line, count] : counts) {
        const bool of_first = first.contains(line), of_second = second.contains(line);
        if (of_first != of_second) votes += (of_first ? sign : -sign) * count;
      }
    };
    add(taken, 1);
    add(next, -1);
    if (taken_side(block) == no_code) {
      const auto ends = [&](std::uint32_t way) {
        const auto& instructions = decisions_.graph().blocks[way].instructions;
        return instructions.empty() || instructions[0].instruction_class == InstructionClass::exit;
      };
      const int by_end = static_cast<int>(ends(ways[0])) - static_cast<int>(ends(ways[1]));
      if (by_end != 0) return by_end;
    }
    return votes;
  }

  int near_votes(std::uint32_t b, std::uint32_t of, const std::vector<std::uint32_t>& ways) const {
    const CodeBlock& block = code_.blocks[b];
    const std::uint32_t self = decisions_.at_end_of(of);
    const LineCounts next = lines_on_way(block.next);
    const std::uint32_t side = taken_side(block);
    return count_votes(block, side == no_code ? LineCounts{} : lines_on_way(side), next,
                       lines_from(ways[0], self, true), lines_from(ways[1], self, true), ways);
  }

  // The same with everything that each side leads to, before the guard comes again.
  int far_votes(std::uint32_t b, std::uint32_t of, const std::vector<std::uint32_t>& ways) const {
    const CodeBlock& block = code_.blocks[b];
    const std::uint32_t self = decisions_.at_end_of(of);
    LineCounts taken = lines_reached(taken_side(block), b), next = lines_reached(block.next, b);
    for (auto entry = taken.begin(); entry != taken.end();)
      if (next.erase(entry->first) != 0)
        entry = taken.erase(entry);
      else
        ++entry;
    return count_votes(block, taken, next, lines_from(ways[0], self, false), lines_from(ways[1], self, false),
                       ways);
  }

  LineCounts lines_reached(std::uint32_t from, std::uint32_t but) const {
    LineCounts lines;
    for_each_reached(code_.blocks.size(), from, [&](std::uint32_t b, auto&& go_on) {
      const CodeBlock& block = code_.blocks[b];
      for (std::uint32_t k = block.first; k < block.last; ++k)
        if (is_plain(code_.instructions[k])) lines[code_.instructions[k].line] = 1;
      if (b == but) return;
      if (block.end != End::exit && block.end != End::ret) go_on(block.next);
      if (block.end == End::guard && block.guarded == Flow::branch) go_on(block.target);
    });
    return lines;
  }

  const CodeGraph& code_;
  const PtxDecisions& decisions_;
  std::vector<GuardLink> links_;
  LineSet guarded_;  // decisions that some guard is near
};

}  // namespace

std::vector<GuardLink> link_guards(const CodeGraph& code, const PtxDecisions& decisions) {
  return Linker(code, decisions).link();
}

}  // namespace warpgrain::profiler::sass
