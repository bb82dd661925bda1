#include "reports/sweep_index.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
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

void require_same_state(const std::string& where, const SweepIndex& found, const SweepIndex& expected) {
  if (found.scene != expected.scene || found.particles != expected.particles || found.step != expected.step)
    throw_input_error(where, "a sweep of " + title_of(found), "one of " + title_of(expected));
  if (found.seed && expected.seed && *found.seed != *expected.seed)
    throw_input_error(where, fmt::format("a sweep of seed {}", *found.seed),
                      fmt::format("one of seed {}", *expected.seed));
}

}  // namespace warpgrain::reports
