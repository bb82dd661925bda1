#include "profiler/formation_bound.hpp"

#include <algorithm>
#include <utility>

#include "profiler/block_runs.hpp"

namespace warpgrain::profiler {
namespace {

void add_each(std::vector<std::uint64_t>& to, const std::vector<std::uint64_t>& from) {
  for (std::size_t i = 0; i < to.size(); ++i) to[i] += from[i];
}

}  // namespace

FormationBound::FormationBound(const KernelGraph& graph, std::vector<FormationPool> pools)
    : runs_(block_runs(graph)), pools_(std::move(pools)), of_lane_(graph.blocks.size()) {
  const std::vector<std::uint64_t> zeros(graph.blocks.size());
  for (const FormationPool& pool : pools_) {
    counts_.push_back({zeros, zeros, 0});
    if (std::none_of(open_.begin(), open_.end(),
                     [&](const OpenPool& open) { return open.threads == pool.threads; }))
      open_.push_back({pool.threads, 0, false, zeros, zeros});
  }
}

void FormationBound::add(std::uint64_t first_thread, std::span<const LaneTrace> lanes) {
  if (pools_.empty()) return;
  for (std::size_t lane = 0; lane < lanes.size(); ++lane)
    if (lanes[lane].blocks != nullptr) add_lane(first_thread + lane, lanes[lane].blocks);
}

void FormationBound::add_lane(std::uint64_t thread, const BlockIndex* blocks) {
  for (; *blocks != trace_end; ++blocks)
    for (const std::uint32_t block : runs_[*blocks])
      if (of_lane_[block]++ == 0) ran_by_lane_.push_back(block);
  for (OpenPool& pool : open_) {
    if (pool.used && pool.number != thread / pool.threads) end(pool);
    pool.number = thread / pool.threads;
    pool.used = true;
    for (const std::uint32_t block : ran_by_lane_) {
      pool.sum[block] += of_lane_[block];
      pool.most[block] = std::max(pool.most[block], of_lane_[block]);
    }
  }
  for (const std::uint32_t block : ran_by_lane_) of_lane_[block] = 0;
  ran_by_lane_.clear();
}

void FormationBound::end_pools() {
  for (OpenPool& pool : open_)
    if (pool.used) end(pool);
}

void FormationBound::end(OpenPool& pool) {
  for (std::size_t p = 0; p < pools_.size(); ++p) {
    if (pools_[p].threads != pool.threads) continue;
    const std::uint64_t width = pools_[p].warp_width;
    for (std::size_t block = 0; block < runs_.size(); ++block)
      counts_[p].issues[block] += std::max((pool.sum[block] + width - 1) / width, pool.most[block]);
    add_each(counts_[p].executions, pool.sum);
    ++counts_[p].pools;
  }
  std::ranges::fill(pool.sum, 0);
  std::ranges::fill(pool.most, 0);
  pool.used = false;
}

void FormationBound::add_counts(const FormationBound& other) {
  for (std::size_t p = 0; p < counts_.size(); ++p) {
    add_each(counts_[p].issues, other.counts_[p].issues);
    add_each(counts_[p].executions, other.counts_[p].executions);
    counts_[p].pools += other.counts_[p].pools;
  }
}

}  // namespace warpgrain::profiler
