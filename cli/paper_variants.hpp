#pragma once
// What a step of each variant takes the paper's GPU and a later one: rows of `warpgrain paper`.

#include <cstddef>
#include <span>
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
// last. Rows that `earlier` has are taken from there. Ends before the next variant when Ctrl-C has come.
struct VariantRows {
  std::vector<reports::PaperReport::Row> rows;
  std::size_t variants = 0;  // that have rows
};
VariantRows variant_rows(const Scene& scene, const std::vector<Variant>& variants,
                         const std::vector<Machine>& machines, const BackendOptions& backend,
                         const MeasuredSteps& measured, std::span<const reports::PaperReport::Row> earlier,
                         Progress& progress);

}  // namespace warpgrain::cli
