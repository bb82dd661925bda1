#include "reports/merged_sweeps.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

// Timings differ from run to run; what the simulator counts does not.
bool counts_agree(const SweepCase& a, const SweepCase& b) {
  return a.headline.has_value() == b.headline.has_value() &&
         (!a.headline || (a.headline->warp_instructions == b.headline->warp_instructions &&
                          a.headline->thread_instructions == b.headline->thread_instructions));
}

}  // namespace

std::vector<SweepShard> read_shards(std::span<const std::string> folders) {
  std::vector<SweepShard> shards;
  for (const std::string& folder : folders)
    shards.push_back({folder, read_sweep(std::filesystem::path(folder) / sweep_index_name)});
  return shards;
}

SweepIndex merged(std::span<const SweepShard> shards) {
  SweepIndex all = shards.front().index;
  for (const SweepShard& shard : shards.subspan(1)) {
    const SweepIndex& index = shard.index;
    require_same_state(shard.folder.string(), index, all);
    for (const SweepCase& sweep_case : index.cases) {
      const auto known = std::ranges::find(all.cases, sweep_case.variant, &SweepCase::variant);
      if (known == all.cases.end()) {
        all.cases.push_back(sweep_case);
      } else if (known->status != CaseStatus::done) {
        *known = sweep_case;
      } else if (sweep_case.status == CaseStatus::done && !counts_agree(*known, sweep_case)) {
        throw_input_error(shard.folder.string(),
                          fmt::format("{} with other counts than in a folder before", sweep_case.variant),
                          "shards of one sweep, by one version of the program");
      }
    }
  }
  return all;
}

}  // namespace warpgrain::reports
