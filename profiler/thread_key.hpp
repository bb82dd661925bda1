#pragma once
// The counts of each thread that launches can be sorted by:
//
//   thread_instructions  instructions that the thread ran; the default
//   LABEL                how often it ran a branch of that label (of a loop's condition: its trips, and once
//   more
//                        where the loop is checked at its head)
//   LINE, FILE:LINE      how often it came to a block with instructions of the source line; FILE may leave
//   out
//                        leading folders
//
// They are sums over the blocks of its trace.

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/kernel_graph.hpp"
#include "profiler/source_lines.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

class ThreadKey {
 public:
  // Empty when the kernel has no such count. InputError for a line number that stands in several files,
  // naming them.
  static std::optional<ThreadKey> find(const KernelGraph& graph, const SourceLines& source,
                                       std::string_view key);

  std::uint64_t count(const BlockIndex* blocks) const;

 private:
  // `of_block`, [n_blocks]: what running the block counts.
  ThreadKey(const KernelGraph& graph, std::span<const std::uint64_t> of_block);

  std::vector<std::uint64_t> of_entry_;  // [n_blocks]: what a recorded block and those that follow count
};

// Throws InputError that names the keys of the kernel.
[[noreturn]] void throw_unknown_thread_key(const KernelGraph& graph, const SourceLines& source,
                                           std::string_view key);

}  // namespace warpgrain::profiler
