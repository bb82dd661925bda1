#pragma once
// Chung & Ooi's impact tests 1 to 4 ("Benchmark tests for verifying discrete element modelling codes at
// particle impact level", Granular Matter 13, 2011) beside closed forms.

#include <vector>

#include "cli/accuracy/setting.hpp"
#include "reports/study_report.hpp"

namespace warpgrain::cli {

// Of the double reference, and of each case at the scenes' steps times its factor.
std::vector<reports::StudyReport::Table> impact_tables(const std::vector<AccuracyCase>& cases,
                                                       const BackendOptions& options);

}  // namespace warpgrain::cli
