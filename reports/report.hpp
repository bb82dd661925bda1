#pragma once
// A SIMT divergence report, format "warpgrain.report/1": what the simulator counted for one or more kernel
// launches, and everything needed to count it again. docs/report-format.md explains every key;
// docs/schemas/report-1.schema.json is its JSON Schema. A report holds no timings and no dates, so that the
// same input gives the same bytes.

#include <cstdint>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/machine.hpp"
#include "profiler/profile.hpp"
#include "reports/bed.hpp"
#include "reports/generator.hpp"
#include "reports/list_making.hpp"
#include "reports/modelled_parts.hpp"
#include "reports/source_text.hpp"
#include "reports/state_sample.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view report_format = "warpgrain.report/1";

// The PTX that was run, so that the same code can be run on a GPU.
struct PtxModule {
  std::string hash;  // text_hash of it
  std::string file;  // beside the report; empty where it was not kept
};

struct LaunchReport {
  profiler::LaunchCounters counters;
  SourceText source;
  PtxModule ptx;
};

struct Report {
  Generator generator;
  std::string command_line;            // as it was called
  std::optional<std::string> scene;    // name; none for a launch file
  std::optional<std::string> variant;  // branchy/cells/cell/fp32/default
  ModelledParts model;                 // of a scene's kernels
  std::optional<std::uint64_t> particles;
  std::optional<std::uint64_t> seed;  // of a scene's fill
  std::optional<std::uint64_t> step;  // the time step that was profiled, 0 = the first
  std::vector<StateSample> samples;   // states on the way there, where they were asked for
  std::optional<Bed> bed;             // of a scene
  std::optional<Machine> machine;     // where one was asked for
  // What an instruction is: "ptx" as compiled, "sass" as ptxas made it, "mixed" where it depends on the
  // launch.
  std::string weights = "ptx";
  std::uint64_t buffer_bytes = 0;  // of the buffers that the launches are given, each once
  // Of these, in the sectors that any launch touches; where all footprints were counted.
  std::optional<std::uint64_t> touched_bytes;
  std::optional<ListMaking> list_making;  // of a step that keeps lists which others make anew
  std::vector<std::string> limits;        // what the counts do not say, in sentences
  std::vector<LaunchReport> launches;     // in the order of launching
};

// What the simulator does not model, stated in every report.
std::vector<std::string> simulator_limits();

// A report of this program with generator, limits and launches filled in; the caller adds what it knows of
// the rest.
Report make_report(std::span<const profiler::LaunchProfile> launches, std::string command_line);

// Bytes in the sectors that any of the launches touches; nothing where a footprint was not counted.
std::optional<std::uint64_t> touched_together(
    std::initializer_list<std::span<const profiler::LaunchProfile>> launches);

// One line that says what was profiled: "slit, branchy/cells/cell/fp32/default, 16,384 particles, step
// 4,000"; for a report without a scene, its kernels.
std::string title_of(const Report& report);

}  // namespace warpgrain::reports
