#pragma once
// The columns of a sweep's table, the same on a terminal and on a page.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/sweep_index.hpp"

namespace warpgrain::reports {

struct SweepColumn {
  std::string_view heading;
  std::string_view explanation;
  bool higher_is_better = false;
  std::string_view metric;  // its key in reports/metrics.hpp; empty: none
  // The value to print, "-" where the case has none, and the number to sort by, where there is one.
  std::string (*text)(const SweepCase&);
  std::optional<double> (*value)(const SweepCase&);
};

// All but the first column, which is the variant's name. Predicted and measured times stand there where a
// case has one.
std::vector<SweepColumn> sweep_columns(const SweepIndex& index);

// What the table does not spell out, each once: which kernels are the heaviest, and "opencl: <device>" of the
// back ends.
std::vector<std::string> notes_of(const SweepIndex& index);

// Cases that are not done: "<variant>: <status>: <message>".
std::vector<std::string> troubles_of(const SweepIndex& index);

}  // namespace warpgrain::reports
