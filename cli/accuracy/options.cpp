#include "cli/accuracy/options.hpp"

#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::cli {

void require_sensible_options(const AccuracyOptions& options) {
  for (const std::string& level : options.levels)
    if (std::ranges::find(level_names, level) == level_names.end())
      throw_unknown_name("--level", "level", level, level_names);
  if (std::ranges::find(study_names, options.study) == study_names.end())
    throw_unknown_name("--study", "study", options.study, study_names);
  if (std::ranges::find(reports::cost_names, options.cost) == reports::cost_names.end())
    throw_unknown_name("--cost", "cost", options.cost, reports::cost_names);
  if (options.cost == "predicted_seconds" && options.machine.empty())
    throw_input_error("--cost", "predicted_seconds without --machine", "a machine to predict for");
  if (options.cost == "measured_seconds" && options.measured.empty())
    throw_input_error("--cost", "measured_seconds without --measured", "documents of `warpgrain measure`");
  if (!options.html.empty() && options.study != variants_study)
    throw_input_error("--html", fmt::format("the study of {}", options.study),
                      fmt::format("that of {}", variants_study));
  for (const double factor : options.step_factors)
    if (!(factor >= 0.01 && factor <= 100))
      throw_input_error("--step-factor", fmt::format("{}", factor), "0.01 to 100");
  if (options.seeds < 1 || options.seeds > 100)
    throw_input_error("--seeds", fmt::format("{}", options.seeds), "1 to 100");
  if (options.trajectory_steps == 0 || options.trajectory_steps > 1'000'000)
    throw_input_error("--trajectory-steps", fmt::format("{}", options.trajectory_steps), "1 to 1000000");
}

}  // namespace warpgrain::cli
