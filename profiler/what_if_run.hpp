#pragma once
// Answers what_if.hpp's questions while a launch runs, and behind it.

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/source_lines.hpp"
#include "profiler/trace.hpp"
#include "profiler/trace_store.hpp"
#include "profiler/what_if.hpp"

namespace warpgrain::profiler {

// Sees the traces of the work-groups that one thread of the program runs.
class GroupVisitor {
 public:
  virtual ~GroupVisitor() = default;
  // `group` is the work-group's number in the order of launching; of one chunk they come in ascending order.
  virtual void visit(std::uint64_t group, std::span<const LaneTrace> lanes) = 0;
};

struct WhatIfSetting {
  std::vector<WhatIf> questions;
  bool addresses = true;           // whether traces hold addresses
  unsigned threads = 1;            // of the program, for what is left to do behind the launch
  std::uint64_t trace_memory = 0;  // bytes that kept traces may take
  // Whether questions that sort by what this kernel has not are left out; else they are errors.
  bool skip_unknown_keys = false;
};

class WhatIfRun {
 public:
  // Throws InputError for questions that cannot be answered. `graph` outlives it.
  WhatIfRun(const KernelGraph& graph, const LaunchShape& shape, const SourceLines& source,
            const WhatIfSetting& setting);
  ~WhatIfRun();

  // Work-groups come to visitors in chunks of a multiple of this number, each chunk to one.
  std::uint64_t groups_a_chunk() const { return groups_a_chunk_; }
  // One for each thread of the program; belongs to the run. Not to be called side by side.
  GroupVisitor& new_visitor();
  // The answers, in the order of the questions, when every work-group has been visited.
  std::vector<WhatIfTotals> answers();

 private:
  class Counting;  // questions of one order, counted
  class Keeping;   // and traces kept
  struct Order;
  void count_reordered(const Order& order, std::vector<WhatIfTotals>& answers) const;

  const KernelGraph& graph_;
  const LaunchShape& shape_;
  WhatIfSetting setting_;
  std::uint64_t groups_a_chunk_ = 1;
  std::vector<Order> orders_;
  std::optional<TraceStore> store_;
  std::vector<std::unique_ptr<Keeping>> visitors_;
};

}  // namespace warpgrain::profiler
