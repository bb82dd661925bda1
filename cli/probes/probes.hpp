#pragma once
// The probes of `warpgrain stability`: each is a family of small scenes with one parameter, and an invariant
// that every one of them must keep. One row a probe; the atlas, its table and its page follow from the rows.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "cli/probes/probe_bench.hpp"

namespace warpgrain::cli {

struct ProbeReading {
  double error = 0;  // of the invariant, as a part of its scale; 0 is right
  std::string what;  // what was seen, "restitution 0.731, expected 0.8"
};

struct Probe {
  std::string_view name;
  std::string_view summary;    // of the scenes
  std::string_view parameter;  // what x is
  std::string_view unit;
  std::string_view invariant;
  double from, to;  // of x: from where everything is right to the extreme that is asked for
  double right_within, degraded_within;
  bool needs_friction;  // says nothing of the simple model, which has none
  bool to_rest_steps;   // x ends at ProbeBench::rest_steps
  ProbeReading (*read)(const ProbeBench& bench, double x);
  // Limits are told in this unit, too: so many of it are one `unit`.
  std::string_view other_unit = {};
  double (*others_in_unit)() = nullptr;
};

// All of them, in the order of the atlas.
std::span<const Probe> probes();
// Throws InputError that lists the valid names.
const Probe& probe_named(std::string_view name);

// The rows, by what their scenes are.
std::span<const Probe> impact_probes();
std::span<const Probe> contact_probes();
std::span<const Probe> rest_probes();
std::span<const Probe> time_step_probes();

}  // namespace warpgrain::cli
