#include "profiler/sass/predicated_lanes.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <span>
#include <string_view>
#include <tuple>

#include "profiler/sass/predicates.hpp"

namespace warpgrain::profiler::sass {
namespace {

std::uint64_t sum_of_lanes(std::span<const std::uint64_t> executions) {
  std::uint64_t lanes = 0;
  for (std::size_t n = 0; n < executions.size(); ++n) lanes += executions[n] * n;
  return lanes;
}

// Operations that the assembler expands with predicates of its own.
enum class Expansion : std::uint8_t { none, of_special_function, other };

Expansion expansion_of(std::string_view ptx) {
  constexpr std::array special{"sqrt.", "rsqrt.", "rcp.", "ex2.", "lg2.", "sin.", "cos.", "tanh."};
  constexpr std::array others{"rem.", "selp", "slct", "min.", "max.", "set.", "mov.pred", "cvt."};
  for (const std::string_view name : special)
    if (ptx.starts_with(name)) return Expansion::of_special_function;
  if (ptx.starts_with("div."))
    return ptx.find(".f") != std::string_view::npos ? Expansion::of_special_function : Expansion::other;
  for (const std::string_view name : others)
    if (ptx.starts_with(name)) return Expansion::other;
  return Expansion::none;
}

class PredicatedLaneCounter {
 public:
  PredicatedLaneCounter(const MachineKernel& kernel, const ReplayCounters& counters,
                        const WarpCounters& of_ptx)
      : kernel_(kernel), of_ptx_(of_ptx), rules_(find_predicates(kernel.code)) {
    for (std::uint32_t b = 0; b < kernel.code.blocks.size(); ++b) {
      lanes_.push_back(sum_of_lanes(counters.executions(b)));
      again_.push_back(sum_of_lanes(counters.again(b)));
      taken_.push_back(counters.taken_lanes[b]);
    }
  }

  PredicatedLanes count() {
    note_copies();
    result_.on.resize(kernel_.code.instructions.size());
    for (std::uint32_t b = 0; b < kernel_.code.blocks.size(); ++b) {
      const CodeBlock& block = kernel_.code.blocks[b];
      for (std::uint32_t k = block.first; k < block.last; ++k) {
        result_.on[k] = known(b, k);
        if (k + 1 == block.last) result_.on[k] += again_[b];
      }
    }
    for (const auto& [which, copies] : copies_) derive(copies);
    return std::move(result_);
  }

 private:
  // What stands at a line of the PTX: the n-th of an operation in its block.
  using Which = std::tuple<std::uint32_t, std::uint16_t, std::uint32_t>;
  struct Copies {
    std::uint64_t known_on = 0;                                    // lanes of those whose predicate is known
    std::vector<std::pair<std::uint32_t, std::uint32_t>> unknown;  // blocks and instructions
  };

  std::uint64_t known(std::uint32_t b, std::uint32_t k) const {
    switch (rules_[k]) {
      case PredicateRule::on:
        return lanes_[b];
      case PredicateRule::taken:
        return taken_[b];
      case PredicateRule::not_taken:
        return lanes_[b] - taken_[b];
      default:
        return 0;
    }
  }

  void note_copies() {
    for (std::uint32_t b = 0; b < kernel_.code.blocks.size(); ++b) {
      std::map<std::pair<std::uint32_t, std::uint16_t>, std::uint32_t> before;
      for (std::uint32_t k = kernel_.code.blocks[b].first; k < kernel_.code.blocks[b].last; ++k) {
        const Instruction& i = kernel_.code.instructions[k];
        Copies& copies = copies_[{i.line, i.opcode, before[{i.line, i.opcode}]++}];
        if (rules_[k] == PredicateRule::unknown)
          copies.unknown.emplace_back(b, k);
        else
          copies.known_on += known(b, k);
      }
    }
  }

  // Lanes that the trace has at the instruction's line.
  std::uint64_t in_trace(const Instruction& i) const {
    std::uint64_t lanes = 0;
    for (const PtxPlace& place : kernel_.decisions.places(i.line))
      lanes += sum_of_lanes(of_ptx_.executions(place.block));
    return lanes;
  }

  void derive(const Copies& copies) {
    if (copies.unknown.empty()) return;
    const Instruction& i = kernel_.code.instructions[copies.unknown[0].second];
    const auto& places = kernel_.decisions.places(i.line);
    Expansion expansion = Expansion::other;
    if (!places.empty())
      expansion = expansion_of(
          kernel_.decisions.graph().blocks[places[0].block].instructions[places[0].instruction].text);
    std::uint64_t here = 0;
    for (const auto& [b, k] : copies.unknown) here += lanes_[b];
    const std::uint64_t of_trace = in_trace(i);
    const bool replaces_branch = expansion == Expansion::none && i.flow == Flow::none &&
                                 copies.known_on <= of_trace && of_trace - copies.known_on < here;
    if (!replaces_branch) result_.assumed += here;
    std::uint64_t left = replaces_branch                               ? of_trace - copies.known_on
                         : expansion == Expansion::of_special_function ? 0
                                                                       : here;
    for (const auto& [b, k] : copies.unknown) {
      const std::uint64_t on = std::min(left, lanes_[b]);
      result_.on[k] += on;
      left -= on;
    }
  }

  const MachineKernel& kernel_;
  const WarpCounters& of_ptx_;
  std::vector<PredicateRule> rules_;                  // [instructions]
  std::vector<std::uint64_t> lanes_, again_, taken_;  // [blocks of the code]
  std::map<Which, Copies> copies_;
  PredicatedLanes result_;
};

}  // namespace

PredicatedLanes count_predicated(const MachineKernel& kernel, const ReplayCounters& counters,
                                 const WarpCounters& of_ptx) {
  return PredicatedLaneCounter(kernel, counters, of_ptx).count();
}

}  // namespace warpgrain::profiler::sass
