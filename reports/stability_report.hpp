#pragma once
// Where each variant stops being right, format "warpgrain.stability/1".
// docs/schemas/stability-1.schema.json is its JSON Schema.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view stability_format = "warpgrain.stability/1";

enum class Verdict : std::uint8_t {
  right,
  degraded,       // off by more than counts as right, by less than counts as wrong
  refused,        // the run ended with a line that says why
  wrong,          // and nothing has said so
  not_applicable  // the variant has nothing that the probe could look at
};
inline constexpr std::array<std::string_view, 5> verdict_names{"right", "degraded", "refused", "wrong",
                                                               "not_applicable"};
std::string_view verdict_name(Verdict verdict);

struct StabilityReport {
  struct Probe {
    std::string name, summary, parameter, unit, invariant;
    double from = 0, to = 0;  // of the parameter
    double right_within = 0, degraded_within = 0;
    std::string other_unit = {};  // that limits are told in, too; empty: none
    double others_in_unit = 0;    // so many of it are one `unit`
  };
  struct Sample {
    double x = 0;
    Verdict verdict = Verdict::right;
    std::optional<double> error;  // none where the run was refused, or is no number
    std::string text;             // what was seen, or the line
  };
  // One probe of one variant on one back end.
  struct Cell {
    std::string probe, variant, backend;
    Verdict verdict = Verdict::right;  // the worst of the samples
    // Of the parameter, from `from` on: the last value known to be right or degraded, and the first known not
    // to be. No `until`: not even `from` is; no `beyond`: the whole range.
    std::optional<double> right_until, right_beyond, degraded_until, degraded_beyond;
    std::vector<Sample> samples;  // from `from` to `to`
  };

  Generator generator;
  std::string command_line;
  std::vector<Probe> probes;
  std::vector<Cell> cells;
};

// The first sample that is not right, going from `from`; null when all are.
const StabilityReport::Sample* first_not_right(const StabilityReport::Cell& cell);
// Throws InputError for a cell whose probe the report does not have.
const StabilityReport::Probe& probe_of(const StabilityReport& report, const StabilityReport::Cell& cell);
// "right to 1.2e+03, degraded to 5.5e+03, then wrong: restitution 0.7, expected 0.8"
std::string limits_text(const StabilityReport::Probe& probe, const StabilityReport::Cell& cell);
// How far of the range is right, 0 to 1 in log space.
double share_of_range(const StabilityReport::Probe& probe, const StabilityReport::Cell& cell);

// Throws InputError naming a number that is not finite.
std::string stability_json(const StabilityReport& report);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
StabilityReport read_stability(const std::filesystem::path& file);

// For a terminal: under each probe its variants, those together whose limits are alike.
std::string text_stability(const StabilityReport& report);

// The same as a Markdown table, and what the probes are.
std::string markdown_stability(const StabilityReport& report);

// A page with a heat map: a row a variant, a column a probe.
std::string stability_page(const StabilityReport& report);

}  // namespace warpgrain::reports
