#pragma once
// A report on a terminal:
//
//   slit, branchy/cells/cell/fp32/default, 16,384 particles, step 4,000
//
//                                  SIMT  active          warp  divergent
//   kernel         launches  efficiency   lanes  instructions   branches  ...
//   -------------  --------  ----------  ------  ------------  ---------
//   contact_force         1       0.235     7.5     9,876,543     26.8 %
//   all                   9       0.311     9.9    12,345,678     24.1 %
//
//   contact_force: where lanes idled, of 241,778,612 lost lane slots
//     62.1 %  contact test  (contact/branchy.cl:42)  lanes disagreed in 71.0 % of 123,456 executions
//
//   contact_force: lines with the most warp instructions
//     12.3 %   7.1 lanes  contact/branchy.cl:57  const float distance = ...

#include <cstddef>
#include <string>

#include "reports/report.hpp"

namespace warpgrain::reports {

struct TextReportOptions {
  std::size_t kernels = 3;  // with details: the heaviest ones
  std::size_t causes = 5;   // of lost lane slots, of each
  std::size_t lines = 5;    // of each
};

std::string text_report(const Report& report, const TextReportOptions& options = {});

}  // namespace warpgrain::reports
