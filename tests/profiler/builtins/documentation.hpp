#pragma once
// docs/builtins.md: what the tests measure, a row a function.

#include <string>
#include <vector>

#include "tests/profiler/builtins/measurement.hpp"

namespace warpgrain::profiler::builtins {

struct Section {
  std::string_view title;
  std::span<const MathFunction> functions;
};

std::vector<Section> sections();

struct SectionMeasurements {
  std::vector<Measurement> in_float,
      in_double;  // in the order of the section's functions, absent ones left out
};

SectionMeasurements measure(const Section& section);

// The rows of the section's table.
std::vector<std::string> rows(const Section& section, const SectionMeasurements& measured);

// The whole page; measures everything.
std::string page();

}  // namespace warpgrain::profiler::builtins
