#include "reports/text_report.hpp"

#include <algorithm>
#include <filesystem>
#include <fmt/format.h>
#include <string_view>
#include <utility>
#include <vector>

#include "analysis/sfu_cost.hpp"
#include "reports/diagnostic_summary.hpp"
#include "reports/number_text.hpp"
#include "reports/predicted_times.hpp"
#include "reports/summary.hpp"
#include "reports/text_state_samples.hpp"
#include "reports/text_table.hpp"
#include "reports/weights_text.hpp"

namespace warpgrain::reports {
namespace {

std::vector<std::string> row_of(const std::string& name, std::size_t launches, const Headline& headline) {
  return {
      name,
      count_text(launches),
      fixed_text(headline.simt_efficiency, 3),
      fixed_text(headline.active_lanes, 1),
      count_text(headline.warp_instructions),
      percent_text(static_cast<double>(headline.divergent_branches), static_cast<double>(headline.branches)),
      count_text(headline.sfu_instructions),
      headline.sectors_per_load ? fixed_text(*headline.sectors_per_load, 2) : "-"};
}

std::string kernel_table(const Report& report, const std::vector<KernelSummary>& kernels) {
  using enum TextTable::Align;
  TextTable table({{"kernel", left},
                   {"launches", right},
                   {"SIMT efficiency", right},
                   {"active lanes", right},
                   {"warp instructions", right},
                   {"divergent branches", right},
                   {"SFU instructions", right},
                   {"sectors/load", right}});
  for (const KernelSummary& kernel : kernels)
    table.add_row(row_of(kernel.counters.kernel, kernel.launches, headline_of(kernel.counters)));
  if (kernels.size() > 1) table.add_row(row_of("all", report.launches.size(), headline_of(kernels)));
  return table.text();
}

std::string sfu_table(const Machine& machine, const std::vector<KernelSummary>& kernels) {
  using enum TextTable::Align;
  TextTable table({{"kernel", left},
                   {"SFU instructions", right},
                   {"SFU cycles", right},
                   {"issue cycles", right},
                   {"SFU/issue", right}});
  double serialisation = 0;
  for (const KernelSummary& kernel : kernels) {
    const SfuCost cost = sfu_cost(kernel.counters.totals, kernel.counters.warp_width, machine);
    serialisation = cost.serialisation;
    table.add_row({kernel.counters.kernel, count_text(cost.instructions),
                   count_text(static_cast<std::uint64_t>(cost.cycles)),
                   count_text(static_cast<std::uint64_t>(cost.issue_cycles)),
                   percent_text(cost.cycles, cost.issue_cycles)});
  }
  return fmt::format(
      "\n{}: an instruction on the special-function units takes {} times the cycles of 32-bit arithmetic\n{}",
      machine.name, fixed_text(serialisation, 1), table.text());
}

// Names below the folder that a program was compiled in are short already; others are cut to the file.
std::string place_text(const std::string& file, std::uint32_t line) {
  const std::filesystem::path path(file);
  return fmt::format("{}:{}", path.is_absolute() ? path.filename().string() : file, line);
}

// A line of source as far as a terminal's line may go; what macros make text of has lines of thousands.
std::string_view shortened(std::string_view text) {
  constexpr std::size_t longest = 100;
  return text.substr(0, longest);
}

std::string loss_list(const KernelSummary& kernel, std::size_t how_many) {
  std::vector<std::pair<std::uint64_t, std::string>> losses;
  for (const profiler::BranchTotals& branch : kernel.counters.branches)
    losses.emplace_back(branch.lane_slots_lost,
                        fmt::format("{}  ({})  lanes disagreed in {} of {} executions",
                                    shortened(branch.label), place_text(branch.file, branch.line),
                                    percent_text(static_cast<double>(branch.divergent),
                                                 static_cast<double>(branch.executions)),
                                    count_text(branch.executions)));
  losses.emplace_back(kernel.counters.lane_slots_never_used, "warps that are not full from the start");
  std::stable_sort(losses.begin(), losses.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::string text;
  for (const auto& [lost, cause] : losses) {
    if (how_many-- == 0 || lost == 0) break;
    text += fmt::format(
        "  {:>7}  {}\n",
        percent_text(static_cast<double>(lost), static_cast<double>(kernel.lane_slots_lost())), cause);
  }
  return text;
}

std::string line_list(const KernelSummary& kernel, std::size_t how_many) {
  std::vector<const profiler::LineTotals*> hottest;
  for (const profiler::LineTotals& line : kernel.counters.lines) hottest.push_back(&line);
  std::stable_sort(hottest.begin(), hottest.end(), [](const auto* a, const auto* b) {
    return a->totals.warp_instructions > b->totals.warp_instructions;
  });
  const SourceIndex source(*kernel.source);
  std::string text;
  for (const profiler::LineTotals* line : hottest) {
    if (how_many-- == 0) break;
    const std::string place =
        line->line == 0 ? "instructions without a line" : place_text(line->file, line->line);
    text += fmt::format("  {:>7}  {:>4} lanes  {}  {}",
                        percent_text(static_cast<double>(line->totals.warp_instructions),
                                     static_cast<double>(kernel.counters.totals.warp_instructions)),
                        fixed_text(line->totals.active_lanes(), 1), place,
                        shortened(source.text_of(line->file, line->line)));
    text.erase(text.find_last_not_of(' ') + 1);
    text += '\n';
  }
  return text;
}

std::string what_if_table(const KernelSummary& kernel) {
  using enum TextTable::Align;
  TextTable table({{"width", right},
                   {"policy", left},
                   {"order", left},
                   {"SIMT efficiency", right},
                   {"warp instructions", right},
                   {"against run", right},
                   {"divergent branches", right},
                   {"sectors/load", right}});
  for (const profiler::WhatIfTotals& answer : kernel.counters.what_if) {
    const profiler::Totals& totals = answer.totals;
    table.add_row({count_text(answer.warp_width), policy_text(answer), answer.order,
                   fixed_text(totals.simt_efficiency(answer.warp_width), 3),
                   count_text(totals.warp_instructions),
                   percent_text(static_cast<double>(totals.warp_instructions),
                                static_cast<double>(kernel.counters.totals.warp_instructions)),
                   answer.pool != 0 ? "-"
                                    : percent_text(static_cast<double>(totals.divergent_branches),
                                                   static_cast<double>(totals.branches)),
                   answer.has_requests && totals.global_load.requests != 0
                       ? fixed_text(totals.global_load.sectors_per_request(), 2)
                       : "-"});
  }
  std::string text = table.text();
  for (const std::string& remark : remarks_of(kernel.counters.what_if)) text += fmt::format("  {}\n", remark);
  return text;
}

}  // namespace

std::string text_report(const Report& report, const TextReportOptions& options) {
  const std::vector<KernelSummary> kernels = kernels_of(report);
  std::string text = title_of(report) + "\n\n" + kernel_table(report, kernels);
  for (const std::string& line : weights_lines(report)) text += fmt::format("instructions: {}\n", line);
  text += text_modelled_parts(report.model);
  if (report.machine) text += sfu_table(*report.machine, kernels);
  text += predicted_table(report, kernels);
  if (report.list_making) text += fmt::format("\nthe search's {}\n", text_of(*report.list_making));
  text += text_state_samples(report.samples);
  for (std::size_t k = 0; k < std::min(kernels.size(), options.kernels); ++k) {
    const KernelSummary& kernel = kernels[k];
    if (const std::string losses = loss_list(kernel, options.causes); !losses.empty())
      text += fmt::format("\n{}: where lanes idled, of {} lost lane slots\n{}", kernel.counters.kernel,
                          count_text(kernel.lane_slots_lost()), losses);
    if (!kernel.counters.what_if.empty())
      text += fmt::format("\n{}: what if (the run: {} lanes, {}, as launched)\n{}", kernel.counters.kernel,
                          kernel.counters.warp_width, kernel.counters.policy, what_if_table(kernel));
    if (const std::string lines = line_list(kernel, options.lines); !lines.empty())
      text += fmt::format("\n{}: lines with the most warp instructions\n{}", kernel.counters.kernel, lines);
  }
  const std::vector<std::string> diagnostics = diagnostic_lines(report);
  if (!diagnostics.empty()) text += fmt::format("\nWhat is wrong with the kernels\n");
  for (const std::string& line : diagnostics) text += "  " + line + "\n";
  return text;
}

}  // namespace warpgrain::reports
