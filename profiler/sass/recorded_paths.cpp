#include "profiler/sass/recorded_paths.hpp"

namespace warpgrain::profiler::sass {

RecordedPaths::RecordedPaths(const PtxDecisions& decisions) {
  const KernelGraph& graph = decisions.graph();
  for (std::uint32_t b = 0; b < graph.blocks.size(); ++b) {
    Run& run = runs_.emplace_back();
    decisions.for_run(b, [&](std::uint32_t on_run) {
      const BasicBlock& block = graph.blocks[on_run];
      for (const MemoryAccess& access : block.accesses) {
        const std::uint32_t offset = run.n_addresses++;
        if (!is_path(access)) continue;
        const std::uint32_t line = block.instructions[access.instruction].ptx_line;
        const auto record = by_line_.try_emplace(line, static_cast<std::uint32_t>(by_line_.size())).first;
        run.recorded.push_back({record->second, offset});
      }
    });
  }
  paths_.resize(by_line_.size());
  taken_.resize(by_line_.size());
}

std::uint32_t RecordedPaths::record_of(std::uint32_t line) const {
  const auto found = by_line_.find(line);
  return found == by_line_.end() ? no_record : found->second;
}

void RecordedPaths::read(const LaneTrace& trace) {
  if (paths_.empty()) return;
  for (std::vector<DivisionPath>& of_record : paths_) of_record.clear();
  taken_.assign(taken_.size(), 0);
  if (trace.addresses == nullptr) return;
  const std::uint64_t* addresses = trace.addresses;
  for (const BlockIndex* block = trace.blocks; *block != trace_end; ++block) {
    for (const Recorded& recorded : runs_[*block].recorded)
      paths_[recorded.record].push_back(static_cast<DivisionPath>(addresses[recorded.offset]));
    addresses += runs_[*block].n_addresses;
  }
}

DivisionPath RecordedPaths::next(std::uint32_t record) {
  std::size_t& taken = taken_[record];
  return taken == paths_[record].size() ? DivisionPath::in_line : paths_[record][taken++];
}

}  // namespace warpgrain::profiler::sass
