#include "reports/sweep_columns.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "reports/number_text.hpp"

namespace warpgrain::reports {
namespace {

using Value = std::optional<double>;

Value of_headline(const SweepCase& c, double (*value)(const Headline&)) {
  return c.headline ? Value(value(*c.headline)) : std::nullopt;
}

Value efficiency(const SweepCase& c) {
  return of_headline(c, [](const Headline& h) { return h.simt_efficiency; });
}
Value heaviest_kernel(const SweepCase& c) {
  return of_headline(c, [](const Headline& h) { return h.heaviest_kernel.simt_efficiency; });
}
Value active_lanes(const SweepCase& c) {
  return of_headline(c, [](const Headline& h) { return h.active_lanes; });
}
Value warp_instructions(const SweepCase& c) {
  return of_headline(c, [](const Headline& h) { return static_cast<double>(h.warp_instructions); });
}
Value sfu_instructions(const SweepCase& c) {
  return of_headline(c, [](const Headline& h) { return static_cast<double>(h.sfu_instructions); });
}
Value sectors_per_load(const SweepCase& c) {
  return c.headline ? c.headline->sectors_per_load : std::nullopt;
}

Value device_bytes(const SweepCase& c) { return c.device_bytes_per_particle; }

Value predicted_seconds(const SweepCase& c) {
  return c.headline ? c.headline->predicted_seconds : std::nullopt;
}

Value seconds_per_step(const SweepCase& c) {
  const BackendReading* reading = reading_of(c, "opencl");
  return reading ? reading->seconds_per_step : std::nullopt;
}

Value force_error(const SweepCase& c, double ForceErrorReading::*measure) {
  for (const std::string_view backend : {"opencl", "simt"})
    if (const BackendReading* reading = reading_of(c, backend); reading && reading->force_error)
      return reading->force_error.value().*measure;
  return std::nullopt;
}
Value maximum_error(const SweepCase& c) { return force_error(c, &ForceErrorReading::maximum); }
Value rms_error(const SweepCase& c) { return force_error(c, &ForceErrorReading::root_mean_square); }

template <Value (*value)(const SweepCase&), class Print>
std::string print(const SweepCase& c, Print printer) {
  const Value v = value(c);
  return v ? printer(*v) : "-";
}

template <Value (*value)(const SweepCase&), int decimals>
std::string fixed(const SweepCase& c) {
  return print<value>(c, [](double v) { return fixed_text(v, decimals); });
}
template <Value (*value)(const SweepCase&)>
std::string count(const SweepCase& c) {
  return print<value>(c, [](double v) { return count_text(static_cast<std::uint64_t>(std::llround(v))); });
}
template <Value (*value)(const SweepCase&)>
std::string seconds(const SweepCase& c) {
  return print<value>(c, [](double v) { return seconds_text(v); });
}
template <Value (*value)(const SweepCase&)>
std::string significant(const SweepCase& c) {
  return print<value>(c, [](double v) { return fmt::format("{:.1e}", v); });
}

constexpr SweepColumn columns[] = {
    {"SIMT efficiency", "active lanes / warp width, over every launch of a step", true, "simt_efficiency",
     fixed<efficiency, 3>, efficiency},
    {"of heaviest kernel", "SIMT efficiency of the kernel with the most warp instructions", true,
     "simt_efficiency", fixed<heaviest_kernel, 3>, heaviest_kernel},
    {"active lanes", "thread instructions / warp instructions", true, "active_lanes", fixed<active_lanes, 1>,
     active_lanes},
    {"warp instructions", "instructions issued in a step, one a warp", false, "warp_instructions",
     count<warp_instructions>, warp_instructions},
    {"SFU instructions", "of these, on the special-function unit", false, "sfu_instructions",
     count<sfu_instructions>, sfu_instructions},
    {"sectors/load", "32-byte sectors a global load touches on average", false, "sectors_per_load",
     fixed<sectors_per_load, 2>, sectors_per_load},
    {"bytes a particle", "device memory of all arrays of a step, over the particles", false, "",
     count<device_bytes>, device_bytes},
    {"predicted step", "time of a step by the cost model, on the machine that --machine names", false, "",
     seconds<predicted_seconds>, predicted_seconds},
    {"time/step", "median wall time of a step on the opencl back end", false, "", seconds<seconds_per_step>,
     seconds_per_step},
    {"max error", "largest force error against the double reference, of the largest force", false, "",
     significant<maximum_error>, maximum_error},
    {"rms error", "root mean square of the same over the particles", false, "", significant<rms_error>,
     rms_error},
};

}  // namespace

std::vector<SweepColumn> sweep_columns(const SweepIndex& index) {
  std::vector<SweepColumn> shown(std::begin(columns), std::end(columns));
  for (const auto value : {device_bytes, predicted_seconds, seconds_per_step})
    if (std::ranges::none_of(index.cases, [&](const SweepCase& c) { return value(c).has_value(); }))
      std::erase_if(shown, [&](const SweepColumn& column) { return column.value == value; });
  return shown;
}

std::vector<std::string> notes_of(const SweepIndex& index) {
  std::vector<std::string> notes;
  const auto add = [&](const std::string& note) {
    if (std::find(notes.begin(), notes.end(), note) == notes.end()) notes.push_back(note);
  };
  for (const SweepCase& sweep_case : index.cases)
    if (sweep_case.headline)
      add(fmt::format("heaviest kernel: {}", sweep_case.headline->heaviest_kernel.kernel));
  for (const SweepCase& sweep_case : index.cases)
    for (const BackendReading& reading : sweep_case.backends)
      add(fmt::format("{}: {}", reading.backend, reading.device));
  return notes;
}

std::vector<std::string> troubles_of(const SweepIndex& index) {
  std::vector<std::string> troubles;
  for (const SweepCase& sweep_case : index.cases)
    if (sweep_case.status != CaseStatus::done)
      troubles.push_back(fmt::format("{}: {}: {}", sweep_case.variant, case_status_name(sweep_case.status),
                                     sweep_case.message));
  return troubles;
}

}  // namespace warpgrain::reports
