#include "profiler/ptx/control_flow.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/place.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler::ptx {
namespace {

bool ends_lane(const Statement& s) { return s.opcode == "ret" || s.opcode == "exit" || s.opcode == "trap"; }
// What inlining leaves of a call through a pointer: the pointer and labels, where other calls have lists or
// nothing.
bool is_indirect_call(const Statement& s) {
  return s.opcode == "call" && s.operands.size() > 1 &&
         std::ranges::all_of(s.operands, [](const Operand& o) { return o.kind == Operand::Kind::name; });
}
bool is_branch(const Statement& s) { return s.opcode == "bra" || s.opcode == "brx" || is_indirect_call(s); }

// [statements + 1]: whether a block begins at the statement, and the label by which a branch names it.
struct Boundaries {
  std::vector<bool> begins;
  std::vector<std::string> label;
};

Boundaries find_boundaries(const Function& function, std::string_view where) {
  const std::size_t n = function.statements.size();
  Boundaries boundaries{std::vector<bool>(n + 1, false), std::vector<std::string>(n + 1)};
  boundaries.begins[0] = true;
  boundaries.label[0] = "entry";
  for (std::size_t i = 0; i < n; ++i) {
    const Statement& statement = function.statements[i];
    if (is_terminator(statement)) boundaries.begins[i + 1] = true;
    if (!is_branch(statement)) continue;
    for (const std::string& target : branch_targets(function, statement, where)) {
      const std::size_t at = function.labels.at(target);
      boundaries.begins[at] = true;
      boundaries.label[at] = target;
    }
  }
  return boundaries;
}

void connect(const Function& function, std::vector<Block>& blocks, std::string_view where) {
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    Block& block = blocks[b];
    if (block.first == block.last) continue;
    const Statement& last = function.statements[block.last - 1];
    const std::size_t behind = block.last;
    const bool falls = blocks.back().first >= behind;
    if (is_branch(last)) {
      for (const std::string& target : branch_targets(function, last, where)) {
        const std::uint32_t to = block_at(blocks, function.labels.at(target));
        if (std::find(block.successors.begin(), block.successors.end(), to) == block.successors.end())
          block.successors.push_back(to);
      }
    } else if (ends_lane(last) && last.guard) {
      block.successors.push_back(static_cast<std::uint32_t>(b + 1));
    }
    const bool goes_on = !is_terminator(last) || last.guard;
    if (!goes_on || !falls) continue;
    const std::uint32_t next = block_at(blocks, behind);
    const bool listed =
        std::find(block.successors.begin(), block.successors.end(), next) != block.successors.end();
    // Of a plain branch both ways are listed even when they lead to one place.
    if (!listed || last.opcode == "bra") block.successors.push_back(next);
  }
}

void mark_recorded(std::vector<Block>& blocks) {
  for (std::size_t b = 1; b < blocks.size(); ++b) blocks[b].recorded = false;
  for (const Block& block : blocks)
    if (block.successors.size() > 1)
      for (const std::uint32_t to : block.successors) blocks[to].recorded = true;
}

void mark_loop_headers(std::vector<Block>& blocks) {
  enum class State : std::uint8_t { unseen, open, done };
  std::vector<State> state(blocks.size(), State::unseen);
  std::vector<std::pair<std::uint32_t, std::size_t>> stack{{0, 0}};
  state[0] = State::open;
  while (!stack.empty()) {
    auto& [block, next] = stack.back();
    if (next == blocks[block].successors.size()) {
      state[block] = State::done;
      stack.pop_back();
      continue;
    }
    const std::uint32_t to = blocks[block].successors[next++];
    if (state[to] == State::open) blocks[to].loop_header = true;
    if (state[to] == State::unseen) {
      state[to] = State::open;
      stack.emplace_back(to, 0);
    }
  }
}

}  // namespace

std::uint32_t block_at(std::span<const Block> blocks, std::size_t statement) {
  const auto found = std::upper_bound(blocks.begin(), blocks.end(), statement,
                                      [](std::size_t s, const Block& b) { return s < b.first; });
  // Of several blocks that begin there, all but the last are empty ends of predicated exits.
  return static_cast<std::uint32_t>(found - blocks.begin() - 1);
}

bool is_terminator(const Statement& statement) { return is_branch(statement) || ends_lane(statement); }

std::vector<std::string> branch_targets(const Function& function, const Statement& statement,
                                        std::string_view where) {
  const auto at = [&] { return place(where, statement.line); };
  std::vector<std::string> targets;
  if (statement.opcode == "bra") {
    if (statement.operands.size() != 1)
      throw_input_error(at(), fmt::format("'{}'", statement.text), "one label");
    targets.push_back(statement.operands[0].name);
  } else if (statement.opcode == "call") {
    for (std::size_t i = 1; i < statement.operands.size(); ++i) targets.push_back(statement.operands[i].name);
  } else {
    if (statement.operands.size() != 2)
      throw_input_error(at(), fmt::format("'{}'", statement.text), "an index and a table");
    const auto table = function.branch_tables.find(statement.operands[1].name);
    if (table == function.branch_tables.end() || table->second.empty())
      throw_input_error(at(), fmt::format("table '{}'", statement.operands[1].name),
                        "the label of a .branchtargets");
    targets = table->second;
  }
  for (const std::string& target : targets)
    if (!function.labels.count(target))
      throw_input_error(at(), fmt::format("label '{}'", target), "a label of the function");
  return targets;
}

std::vector<Block> cut_blocks(const Function& function, std::string_view where) {
  const Boundaries boundaries = find_boundaries(function, where);
  const std::size_t n = function.statements.size();
  std::vector<Block> blocks;
  std::string label;
  int part = 0;
  for (std::size_t i = 0; i < n || i == 0;) {
    if (!boundaries.label[i].empty()) label = boundaries.label[i], part = 0;
    Block block;
    block.label = part++ == 0 ? label : fmt::format("{}.{}", label, part - 1);
    block.first = i;
    while (i < n) {
      ++i;
      if (boundaries.begins[i]) break;
    }
    block.last = i;
    const bool ends_predicated =
        block.first < block.last && ends_lane(function.statements[i - 1]) && function.statements[i - 1].guard;
    const std::string end_label = block.label + ".end";
    blocks.push_back(std::move(block));
    if (ends_predicated) blocks.push_back({end_label, i, i, {}, true, false});
    if (n == 0) break;
  }
  // A label at the very end: the lane ends there.
  if (n > 0 && !boundaries.label[n].empty()) blocks.push_back({boundaries.label[n], n, n, {}, true, false});
  if (blocks.size() >= trace_end)
    throw_input_error(place(where, function.line),
                      fmt::format("'{}' has {} basic blocks", function.name, blocks.size()),
                      fmt::format("fewer than {}", trace_end));
  connect(function, blocks, where);
  mark_recorded(blocks);
  mark_loop_headers(blocks);
  return blocks;
}

}  // namespace warpgrain::profiler::ptx
