#pragma once
// What a step of each variant takes the paper's GPU and a later one: rows of `warpgrain paper`.

#include <vector>

#include "analysis/machine.hpp"
#include "cli/accuracy/cost_level.hpp"
#include "cli/progress.hpp"
#include "core/scene.hpp"
#include "reports/paper_report.hpp"
#include "variants/backend.hpp"

namespace warpgrain::cli {

// A row a variant and machine: the predicted time where the machine file has cost constants, else the least
// time (analysis/ least_time.hpp); the readings of the variant beside the machine's own ones, which stand
// last.
std::vector<reports::PaperReport::Row> variant_rows(const Scene& scene, const std::vector<Variant>& variants,
                                                    const std::vector<Machine>& machines,
                                                    const BackendOptions& backend,
                                                    const MeasuredSteps& measured, Progress& progress);

}  // namespace warpgrain::cli
