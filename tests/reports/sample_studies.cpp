#include "sample.hpp"

namespace warpgrain::reports::sample {

PaperReport paper() {
  PaperReport paper;
  paper.scene = "slit";
  paper.rows = {
      {"Table 3", "simple model", "particles/s", 1e6, {}, 2e6, {{3e6, "here: a device"}}, "a <remark>"},
      {"section 6", "factor", "", 4.0, 5.0, 6.0, {}, ""}};
  paper.seed = 7;
  paper.fall_steps = 100;
  paper.samples = state_samples();
  paper.paths = {{"force", "law.cl", 7, 5, 100, 9, 0.7}};
  paper.generator = this_generator();
  paper.command_line = "warpgrain paper";
  return paper;
}

AccuracyReport accuracy() {
  AccuracyReport accuracy;
  accuracy.scene = "settled_bed";
  accuracy.particles = 100;
  accuracy.seed = 7;
  accuracy.seeds = 4;
  for (int k = 0; k < 3; ++k) {
    AccuracyReport::Case row;
    row.variant = "case/" + std::to_string(k);
    row.relative_cost = 1 + k;
    row.bytes = 1000;
    row.force = AccuracyReport::Force{1e-6 / (k + 1), 1e-7 / (k + 1), 3, 1};
    row.ensemble = {{"packing fraction", "", 0.6 + 0.01 * k, 0.005, {}, {}, false}};
    if (k > 0)
      row.ensemble[0].difference = 0.01 * k, row.ensemble[0].difference_half_width = 0.007,
      row.ensemble[0].significant = k == 2;
    if (k == 2) row.dominated_by = "case/1";
    accuracy.cases.push_back(row);
  }
  accuracy.generator = this_generator();
  accuracy.command_line = "warpgrain accuracy";
  return accuracy;
}

StabilityReport stability() {
  StabilityReport stability;
  stability.probes = {{"speed", "a fall", "speed", "m/s", "energy", 1, 100, 0.01, 0.05}};
  for (int k = 0; k < 3; ++k) {
    StabilityReport::Cell cell{"speed",
                               "case/" + std::to_string(k),
                               "opencl",
                               Verdict::wrong,
                               10.0 * (k + 1),
                               11.0 * (k + 1),
                               {},
                               {},
                               {}};
    cell.samples = {{1, Verdict::right, 0.0, ""}, {100, Verdict::wrong, 1.0, "too much"}};
    stability.cells.push_back(cell);
  }
  stability.generator = this_generator();
  stability.command_line = "warpgrain stability";
  return stability;
}

Comparison comparison() {
  Comparison comparison;
  comparison.base = "a.json";
  comparison.other = "b.json";
  comparison.differences = {{"force", "warp_instructions", 100, 120},
                            {"force", "branches", 7, 7},
                            {"sort", "warp_instructions", 10, 5}};
  comparison.generator = this_generator();
  comparison.command_line = "warpgrain comparison";
  return comparison;
}

}  // namespace warpgrain::reports::sample
