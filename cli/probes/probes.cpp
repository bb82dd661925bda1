#include "cli/probes/probes.hpp"

#include <algorithm>

#include "core/error.hpp"

namespace warpgrain::cli {

std::span<const Probe> probes() {
  static const std::vector<Probe> all = [] {
    std::vector<Probe> rows;
    for (const auto part : {time_step_probes(), impact_probes(), contact_probes(), rest_probes()})
      rows.insert(rows.end(), part.begin(), part.end());
    return rows;
  }();
  return all;
}

const Probe& probe_named(std::string_view name) {
  const auto found = std::ranges::find(probes(), name, &Probe::name);
  if (found == probes().end()) {
    std::vector<std::string_view> valid;
    for (const Probe& probe : probes()) valid.push_back(probe.name);
    throw_unknown_name("--probe", "probe", name, valid);
  }
  return *found;
}

}  // namespace warpgrain::cli
