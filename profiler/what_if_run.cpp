#include "profiler/what_if_run.hpp"

#include <algorithm>
#include <atomic>
#include <bit>
#include <fmt/format.h>
#include <numeric>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "profiler/formation_bound.hpp"
#include "profiler/merge.hpp"
#include "profiler/observers/totals.hpp"
#include "profiler/thread_permutation.hpp"

namespace warpgrain::profiler {
namespace {

void check(const WhatIf& question) {
  check_warp_width(question.warp_width);
  if (question.pool == 0) return;
  if (question.pool < question.warp_width || question.pool > max_pool || !std::has_single_bit(question.pool))
    throw_input_error(
        "--what-if pool", fmt::format("{} threads", question.pool),
        fmt::format("a power of two from the warp width, {}, to {}", question.warp_width, max_pool));
}

Totals totals_of(const KernelGraph& graph, const FormationBound::Counts& counts) {
  Totals totals;
  for (std::size_t b = 0; b < graph.blocks.size(); ++b)
    for (const Instruction& instruction : graph.blocks[b].instructions) {
      totals.warp_instructions += counts.issues[b];
      totals.thread_instructions += counts.executions[b];
      totals.sfu_instructions += counts.issues[b] * instruction.sfu_operations;
      InstructionCount& mix = totals.instruction_mix[static_cast<std::size_t>(instruction.instruction_class)];
      mix.warp += counts.issues[b];
      mix.thread += counts.executions[b];
    }
  return totals;
}

// Whether lanes of a warp exchange values, so that other warps might have computed something else.
bool has_warp_level(const KernelGraph& graph) {
  for (const BasicBlock& block : graph.blocks)
    for (const Instruction& instruction : block.instructions)
      if (instruction.instruction_class == InstructionClass::warp_level) return true;
  return false;
}

}  // namespace

// The questions of one order; those that are the same but for the order share nothing but the traces.
struct WhatIfRun::Order {
  ThreadOrder order;
  std::optional<ThreadKey> key;
  std::vector<std::size_t> warps, pools;  // numbers of questions: policies, and bounds
};

class WhatIfRun::Counting : public GroupVisitor {
 public:
  Counting(const WhatIfRun& run, const Order& order)
      : run_(run), order_(order), bound_(run.graph_, pools_of(run, order)) {
    counters_.reserve(order.warps.size());  // mergers hold on to them
    for (const std::size_t q : order.warps) {
      const WhatIf& question = run.setting_.questions[q];
      counters_.emplace_back(run.graph_, question.warp_width);
      mergers_.push_back(make_counting_merger(run.graph_, question.policy, counters_.back()));
    }
  }

  void visit(std::uint64_t group, std::span<const LaneTrace> lanes) override {
    for (std::size_t k = 0; k < mergers_.size(); ++k)
      merge_warps(*mergers_[k], lanes, counters_[k].warp_width);
    if (!run_.graph_.has_barrier) {
      bound_.add(group * run_.shape_.work_group_size(), lanes);
    } else {  // a pool is one work-group's
      bound_.add(0, lanes);
      bound_.end_pools();
    }
  }

  void add(Counting& other) {
    for (std::size_t k = 0; k < counters_.size(); ++k) counters_[k].add(other.counters_[k]);
    bound_.end_pools();
    other.bound_.end_pools();
    bound_.add_counts(other.bound_);
  }

  void answer(std::vector<WhatIfTotals>& answers) {
    bound_.end_pools();
    for (std::size_t k = 0; k < counters_.size(); ++k) {
      WhatIfTotals& answer = answers[order_.warps[k]];
      answer.warps = counters_[k].warps;
      answer.totals = launch_totals(run_.graph_, counters_[k]);
    }
    for (std::size_t k = 0; k < order_.pools.size(); ++k)
      answers[order_.pools[k]].totals = totals_of(run_.graph_, bound_.counts()[k]);
  }

 private:
  static std::vector<FormationPool> pools_of(const WhatIfRun& run, const Order& order) {
    std::vector<FormationPool> pools;
    for (const std::size_t q : order.pools)
      pools.push_back({run.setting_.questions[q].pool, run.setting_.questions[q].warp_width});
    return pools;
  }

  const WhatIfRun& run_;
  const Order& order_;
  std::vector<WarpCounters> counters_;  // of the questions order.warps
  std::vector<std::unique_ptr<WarpMerger>> mergers_;
  FormationBound bound_;  // of the questions order.pools
};

class WhatIfRun::Keeping : public GroupVisitor {
 public:
  Keeping(WhatIfRun& run) : counting(run, run.orders_[0]), group_size_(run.shape_.work_group_size()) {
    if (run.store_) writer_.emplace(*run.store_);
  }
  void visit(std::uint64_t group, std::span<const LaneTrace> lanes) override {
    counting.visit(group, lanes);
    if (writer_) writer_->keep(group * group_size_, lanes);
  }

  Counting counting;  // of the launched order

 private:
  std::uint64_t group_size_;
  std::optional<TraceStore::Writer> writer_;
};

WhatIfRun::WhatIfRun(const KernelGraph& graph, const LaunchShape& shape, const SourceLines& source,
                     const WhatIfSetting& setting)
    : graph_(graph), shape_(shape), setting_(setting) {
  orders_.push_back({});  // as launched
  std::vector<WhatIf> answerable;
  for (const WhatIf& question : setting.questions) {
    check(question);
    auto order = std::ranges::find(orders_, question.order, &Order::order);
    if (order == orders_.end()) {
      std::optional<ThreadKey> key;
      if (question.order.kind == ThreadOrder::Kind::sorted) {
        key = ThreadKey::find(graph, source, question.order.key);
        if (!key && setting.skip_unknown_keys) continue;
        if (!key) throw_unknown_thread_key(graph, source, question.order.key);
      }
      if (!shape.is_uniform())
        throw_input_error("--what-if order", "a launch whose last work-groups are smaller",
                          "a global size that the local size divides");
      orders_.push_back({question.order, std::move(key), {}, {}});
      order = orders_.end() - 1;
    }
    (question.pool == 0 ? order->warps : order->pools).push_back(answerable.size());
    answerable.push_back(question);
    if (question.pool != 0)
      groups_a_chunk_ = std::max<std::uint64_t>(
          groups_a_chunk_, question.pool / std::gcd(question.pool, shape.work_group_size()));
  }
  setting_.questions = std::move(answerable);
  if (orders_.size() > 1) {
    const auto groups = shape.group_count();
    store_.emplace(groups[0] * groups[1] * groups[2] * shape.work_group_size(), setting.trace_memory);
  }
}

WhatIfRun::~WhatIfRun() = default;

GroupVisitor& WhatIfRun::new_visitor() {
  visitors_.push_back(std::make_unique<Keeping>(*this));
  return *visitors_.back();
}

// Forms the work-groups of the launch anew and counts them.
void WhatIfRun::count_reordered(const Order& order, std::vector<WhatIfTotals>& answers) const {
  const std::uint64_t group_size = shape_.work_group_size();
  const std::uint64_t n_groups = store_->n_threads() / group_size;
  const std::vector<std::uint64_t> threads =
      permuted_threads(order.order, order.key ? &*order.key : nullptr, *store_,
                       graph_.has_barrier ? group_size : store_->n_threads());
  std::vector<std::unique_ptr<Counting>> of_threads;
  for (unsigned k = 0; k < setting_.threads; ++k)
    of_threads.push_back(std::make_unique<Counting>(*this, order));
  std::atomic<std::uint64_t> next_chunk = 0;
  const auto work = [&](Counting& counting) {
    std::vector<LaneTrace> lanes(group_size);
    for (;;) {
      const std::uint64_t begin = next_chunk++ * groups_a_chunk_;
      if (begin >= n_groups) return;
      for (std::uint64_t group = begin; group < std::min(begin + groups_a_chunk_, n_groups); ++group) {
        for (std::uint64_t lane = 0; lane < group_size; ++lane)
          lanes[lane] = store_->trace(threads[group * group_size + lane]);
        counting.visit(group, lanes);
      }
    }
  };
  {
    std::vector<std::jthread> others;
    for (std::size_t k = 1; k < of_threads.size(); ++k) others.emplace_back([&, k] { work(*of_threads[k]); });
    work(*of_threads[0]);
  }
  for (std::size_t k = 1; k < of_threads.size(); ++k) of_threads[0]->add(*of_threads[k]);
  of_threads[0]->answer(answers);
}

std::vector<WhatIfTotals> WhatIfRun::answers() {
  std::vector<WhatIfTotals> answers;
  for (const WhatIf& question : setting_.questions) {
    WhatIfTotals answer;
    answer.warp_width = question.warp_width;
    if (question.pool == 0) answer.policy = merge_policy_name(question.policy);
    answer.order = question.order.name();
    answer.pool = question.pool;
    const bool launched = question.order.kind == ThreadOrder::Kind::launched;
    answer.has_requests = launched && question.pool == 0 && setting_.addresses;
    if (graph_.has_barrier && (!launched || question.pool != 0))
      answer.remark = "the kernel has barriers: threads stay within their work-group";
    if (has_warp_level(graph_))
      answer.remark += fmt::format("{}lanes exchange values as they did in the run's own warps",
                                   answer.remark.empty() ? "" : "; ");
    answers.push_back(std::move(answer));
  }
  for (std::size_t k = 1; k < visitors_.size(); ++k) visitors_[0]->counting.add(visitors_[k]->counting);
  visitors_.at(0)->counting.answer(answers);
  for (std::size_t k = 1; k < orders_.size(); ++k) count_reordered(orders_[k], answers);
  return answers;
}

}  // namespace warpgrain::profiler
