#include "reports/sweep_index.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "reports/number_text.hpp"

namespace warpgrain::reports {

const BackendReading* reading_of(const SweepCase& sweep_case, std::string_view backend) {
  const auto found = std::find_if(sweep_case.backends.begin(), sweep_case.backends.end(),
                                  [&](const BackendReading& reading) { return reading.backend == backend; });
  return found == sweep_case.backends.end() ? nullptr : &*found;
}

std::string title_of(const SweepIndex& index) {
  return fmt::format("{}, {} particles, step {}: {} {}", index.scene, count_text(index.particles),
                     count_text(index.step), index.cases.size(),
                     index.cases.size() == 1 ? "variant" : "variants");
}

}  // namespace warpgrain::reports
