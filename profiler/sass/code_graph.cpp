#include "profiler/sass/code_graph.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/sass/decoder.hpp"

namespace warpgrain::profiler::sass {
namespace {

bool ends_block(const Instruction& i) {
  switch (i.flow) {
    case Flow::branch:
    case Flow::indirect_branch:
    case Flow::call:
    case Flow::indirect_call:
    case Flow::ret:
    case Flow::exit:
    case Flow::meet:
    case Flow::warp_meet:
    case Flow::yield:
      return true;
    default:
      return false;
  }
}

// The last row at or before each instruction.
void note_lines(const std::vector<LineRow>& rows, std::vector<Instruction>& instructions) {
  std::size_t row = 0;
  std::uint32_t line = 0;
  for (Instruction& i : instructions) {
    for (; row < rows.size() && rows[row].address <= i.address; ++row) line = rows[row].line;
    i.line = line;
  }
}

class Cutter {
 public:
  Cutter(const KernelCode& code, unsigned sm) {
    graph_.instructions = decode(code.text, sm);
    note_lines(code.lines, graph_.instructions);
    for (const std::uint32_t address : code.branch_table)
      table_.push_back(is_inside(address) ? address / instruction_bytes : no_code);
  }

  CodeGraph cut() {
    find_beginnings();
    for (std::uint32_t first = 0; first < graph_.instructions.size();) {
      std::uint32_t last = first + 1;
      while (last < graph_.instructions.size() && !begins_[last]) ++last;
      CodeBlock block;
      block.first = first;
      block.last = last;
      graph_.blocks.push_back(std::move(block));
      first = last;
    }
    for (std::uint32_t b = 0; b < graph_.blocks.size(); ++b) finish(b);
    fill_tables();
    return std::move(graph_);
  }

 private:
  bool is_inside(std::uint32_t address) const {
    return address % instruction_bytes == 0 && address / instruction_bytes < graph_.instructions.size();
  }

  std::uint32_t target_of(const Instruction& i) const {
    if (!is_inside(i.target))
      throw_input_error(fmt::format("machine code at 0x{:x}", i.address),
                        fmt::format("a jump to 0x{:x}", i.target), "a place in the kernel");
    return i.target / instruction_bytes;
  }

  void find_beginnings() {
    const std::vector<Instruction>& all = graph_.instructions;
    begins_.assign(all.size() + 1, false);
    begins_[0] = true;
    for (std::uint32_t k = 0; k < all.size(); ++k) {
      if (ends_block(all[k])) begins_[k + 1] = true;
      // Lanes that come to a meeting one group after another issue it each.
      if (all[k].flow == Flow::meet || all[k].flow == Flow::warp_meet) begins_[k] = true;
      if (all[k].flow == Flow::branch || all[k].flow == Flow::call) begins_[target_of(all[k])] = true;
    }
    for (const std::uint32_t at : table_)
      if (at != no_code) begins_[at] = true;
  }

  std::uint32_t block_at(std::uint32_t instruction) const {
    const auto found = std::ranges::upper_bound(graph_.blocks, instruction, {}, &CodeBlock::first);
    return static_cast<std::uint32_t>(found - graph_.blocks.begin() - 1);
  }

  void finish(std::uint32_t b) {
    CodeBlock& block = graph_.blocks[b];
    const Instruction& last = graph_.last_of(block);
    if (b + 1 < graph_.blocks.size()) block.next = b + 1;
    for (std::uint32_t k = block.first; k < block.last; ++k) note_action(graph_.instructions[k], last, block);
    if (!ends_block(last)) return;
    if (last.flow == Flow::branch || last.flow == Flow::call) block.target = block_at(target_of(last));
    const bool conditional = last.is_conditional() || last.if_divergent;
    switch (last.flow) {
      case Flow::meet:
        block.end = End::meet;
        block.barrier = last.barrier;
        return;
      case Flow::warp_meet:
        block.end = End::warp_meet;
        return;
      case Flow::yield:
        block.end = End::yield;
        return;
      case Flow::indirect_branch:
        block.end = End::indirect;
        return;
      case Flow::indirect_call:
        throw_input_error(fmt::format("machine code at 0x{:x}", last.address), "a call through a pointer",
                          "calls of functions of the module");
      default:
        break;
    }
    if (conditional) {
      block.end = End::guard;
      block.guarded = last.flow;
      block.if_divergent = last.if_divergent;
    } else if (last.flow == Flow::branch) {
      block.next = block.target;
    } else {
      block.end = last.flow == Flow::call ? End::call : last.flow == Flow::ret ? End::ret : End::exit;
    }
  }

  // Where the table of an indirect branch begins in the constant bank: the load before it says so.
  std::uint32_t table_begin(const CodeBlock& block) const {
    for (std::uint32_t k = block.last; k-- > 0;)
      if (graph_.instructions[k].constant_bank == branch_table_bank)
        return graph_.instructions[k].constant_offset / static_cast<std::uint32_t>(sizeof(std::uint32_t));
    return 0;
  }

  // A table ends where the next one begins.
  void fill_tables() {
    std::vector<std::uint32_t> begins{static_cast<std::uint32_t>(table_.size())};
    for (const CodeBlock& block : graph_.blocks)
      if (block.end == End::indirect) begins.push_back(table_begin(block));
    std::ranges::sort(begins);
    for (CodeBlock& block : graph_.blocks) {
      if (block.end != End::indirect) continue;
      const std::uint32_t begin = table_begin(block);
      const auto end = std::ranges::upper_bound(begins, begin);
      for (std::uint32_t k = begin; end != begins.end() && k < *end; ++k) {
        if (table_[k] == no_code) continue;
        const std::uint32_t to = block_at(table_[k]);
        if (std::ranges::find(block.table, to) == block.table.end()) block.table.push_back(to);
      }
      if (block.table.empty())
        throw_input_error(fmt::format("machine code at 0x{:x}", graph_.last_of(block).address),
                          "a jump through no table", "one in the constant bank");
    }
  }

  static void note_action(const Instruction& i, const Instruction& last, CodeBlock& block) {
    if (i.flow != Flow::open && i.flow != Flow::leave && i.flow != Flow::save && i.flow != Flow::restore)
      return;
    MaskAction action{i.flow, i.barrier, i.reg, MaskAction::Lanes::all};
    if (i.flow == Flow::leave && i.guard != always && last.guard == i.guard)
      action.lanes =
          last.guard_negated == i.guard_negated ? MaskAction::Lanes::taken : MaskAction::Lanes::not_taken;
    block.actions.push_back(action);
  }

  CodeGraph graph_;
  std::vector<std::uint32_t> table_;  // of the constant bank: instructions, no_code for other words
  std::vector<bool> begins_;
};

}  // namespace

CodeGraph cut_code(const KernelCode& code, unsigned sm) { return Cutter(code, sm).cut(); }

}  // namespace warpgrain::profiler::sass
