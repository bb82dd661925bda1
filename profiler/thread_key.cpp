#include "profiler/thread_key.hpp"

#include <algorithm>
#include <charconv>
#include <fmt/format.h>
#include <map>
#include <set>

#include "core/error.hpp"
#include "profiler/block_runs.hpp"
#include "profiler/observers/branches.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::string_view instructions_key = "thread_instructions";

// Whether `name` is the file, or its end from a folder on.
bool names_file(std::string_view name, std::string_view file) {
  return file.ends_with(name) && (file.size() == name.size() || file[file.size() - name.size() - 1] == '/');
}

// The blocks of a line by the files that have it.
std::map<std::string, std::set<std::uint32_t>> blocks_of_line(const KernelGraph& graph, std::string_view file,
                                                              std::uint32_t line) {
  std::map<std::string, std::set<std::uint32_t>> blocks;
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b)
    for (const Instruction& instruction : graph.blocks[b].instructions) {
      const SourceLocation& place = instruction.location;
      if (place.line == 0 || place.line != line) continue;
      if (file.empty() || names_file(file, graph.files[place.file]))
        blocks[graph.files[place.file]].insert(b);
    }
  return blocks;
}

std::vector<std::uint64_t> count_line(const KernelGraph& graph, std::string_view key) {
  const std::size_t colon = key.rfind(':');
  const std::string_view file = colon == std::string_view::npos ? std::string_view() : key.substr(0, colon);
  const std::string_view number = colon == std::string_view::npos ? key : key.substr(colon + 1);
  std::uint32_t line = 0;
  const char* const end = number.data() + number.size();
  const auto [stop, error] = std::from_chars(number.data(), end, line);
  if (error != std::errc{} || stop != end) return {};
  const auto blocks = blocks_of_line(graph, file, line);
  if (blocks.size() > 1) {
    std::string files;
    for (const auto& [name, unused] : blocks)
      files += fmt::format("{}{}", files.empty() ? "" : " and ", name);
    throw_input_error(fmt::format("order sorted:{}", key), fmt::format("line {} stands in {}", line, files),
                      "FILE:LINE");
  }
  std::vector<std::uint64_t> counts(blocks.empty() ? 0 : graph.blocks.size());
  if (!blocks.empty())
    for (const std::uint32_t b : blocks.begin()->second) counts[b] = 1;
  return counts;
}

std::vector<std::uint64_t> count_label(const KernelGraph& graph, const SourceLines& source,
                                       std::string_view label) {
  std::vector<std::uint64_t> counts(graph.blocks.size());
  bool found = false;
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    if (graph.blocks[b].successors.size() < 2 || branch_label(graph, b, source) != label) continue;
    counts[b] = 1;
    found = true;
  }
  return found ? counts : std::vector<std::uint64_t>();
}

}  // namespace

std::optional<ThreadKey> ThreadKey::find(const KernelGraph& graph, const SourceLines& source,
                                         std::string_view key) {
  std::vector<std::uint64_t> counts;
  if (key == instructions_key) {
    for (const BasicBlock& block : graph.blocks) counts.push_back(block.instructions.size());
    return ThreadKey(graph, counts);
  }
  counts = count_label(graph, source, key);
  if (counts.empty()) counts = count_line(graph, key);
  return counts.empty() ? std::nullopt : std::optional(ThreadKey(graph, counts));
}

ThreadKey::ThreadKey(const KernelGraph& graph, std::span<const std::uint64_t> of_block)
    : of_entry_(graph.blocks.size()) {
  const std::vector<std::vector<std::uint32_t>> runs = block_runs(graph);
  for (std::size_t b = 0; b < runs.size(); ++b)
    for (const std::uint32_t block : runs[b]) of_entry_[b] += of_block[block];
}

std::uint64_t ThreadKey::count(const BlockIndex* blocks) const {
  std::uint64_t sum = 0;
  for (; *blocks != trace_end; ++blocks) sum += of_entry_[*blocks];
  return sum;
}

void throw_unknown_thread_key(const KernelGraph& graph, const SourceLines& source, std::string_view key) {
  std::vector<std::string> names{std::string(instructions_key)};
  std::map<std::string, std::pair<std::uint32_t, std::uint32_t>> lines;  // first and last of each file
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    if (graph.blocks[b].successors.size() > 1) {
      const std::string label = branch_label(graph, b, source);
      if (std::find(names.begin(), names.end(), label) == names.end()) names.push_back(label);
    }
    for (const Instruction& instruction : graph.blocks[b].instructions) {
      const std::uint32_t line = instruction.location.line;
      if (line == 0) continue;
      const auto place = lines.try_emplace(graph.files[instruction.location.file], line, line).first;
      place->second = {std::min(place->second.first, line), std::max(place->second.second, line)};
    }
  }
  for (const auto& [file, range] : lines)
    names.push_back(fmt::format("a line with instructions, {}:{} to {}", file, range.first, range.second));
  const std::vector<std::string_view> valid(names.begin(), names.end());
  throw_unknown_name("order sorted", "thread count", key, valid);
}

}  // namespace warpgrain::profiler
