#include "reports/list_making.hpp"

#include <fmt/format.h>

#include "reports/number_text.hpp"
#include "reports/report.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports {

ListMaking list_making(std::span<const profiler::LaunchProfile> step,
                       std::span<const profiler::LaunchProfile> lists, std::uint64_t steps_between,
                       const std::optional<Machine>& machine) {
  Report of_lists = make_report(lists, {});
  of_lists.machine = machine;
  of_lists.scene = "";  // whichever: its launches follow each other
  of_lists.touched_bytes = touched_together({step, lists});
  const Headline headline = headline_of(kernels_of(of_lists));
  return {steps_between, headline.warp_instructions, headline.thread_instructions,
          headline.predicted_seconds};
}

std::string text_of(const ListMaking& making) {
  std::string text = fmt::format("lists are made anew about every {} steps: {} warp instructions",
                                 count_text(making.steps_between), count_text(making.warp_instructions));
  if (making.predicted_seconds)
    text += fmt::format(", {}; {} a step", seconds_text(*making.predicted_seconds),
                        seconds_text(making.predicted_seconds_a_step()));
  return text;
}

}  // namespace warpgrain::reports
