#pragma once
// The index of a sweep, format "warpgrain.sweep/1": one row a case, with its headline numbers and where its
// report lies. docs/schemas/sweep-1.schema.json is its JSON Schema.

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"
#include "reports/summary.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view sweep_format = "warpgrain.sweep/1";

enum class CaseStatus : std::uint8_t {
  done,    // everything that was asked for is there
  failed,  // `message` says why; what was read before stands
  skipped  // not run: the combination makes no sense or needs what is not installed; `message` says what
};
std::string_view case_status_name(CaseStatus status);

// Errors of one force evaluation against the double reference, relative as analysis/force_error.hpp has it.
struct ForceErrorReading {
  double maximum = 0;
  double root_mean_square = 0;
};

// What one back end gave for a case.
struct BackendReading {
  std::string backend;                     // host, opencl, cuda, simt
  std::string device;                      // as it calls itself
  std::uint64_t steps = 0;                 // timed
  std::optional<double> seconds_per_step;  // median; none where the clock says nothing of a device (simt)
  std::optional<ForceErrorReading> force_error;
};

struct SweepCase {
  std::string variant;
  std::map<std::string, std::string> axes;  // axis -> value
  CaseStatus status = CaseStatus::done;
  std::string message;                              // empty when done
  std::optional<std::string> report_file;           // "warpgrain.report/1", relative to the index
  std::optional<Headline> headline;                 // of every launch of the report together
  std::optional<double> device_bytes_per_particle;  // of all arrays of the step
  // Of all kernels of a step together, at states on the way; empty where none was asked for.
  struct Sample {
    std::uint64_t step = 0;
    double time = 0;  // s
    double simt_efficiency = 0;
  };
  std::vector<Sample> samples;
  std::vector<BackendReading> backends;
};

struct SweepIndex {
  Generator generator;
  std::string command_line;
  std::string scene;
  std::uint64_t particles = 0;
  std::optional<std::uint64_t> seed;  // of the scene's fill
  std::uint64_t step = 0;             // the time step that was profiled
  std::vector<SweepCase> cases;
};

// The reading of that back end; null when the case has none.
const BackendReading* reading_of(const SweepCase& sweep_case, std::string_view backend);

// "slit, 16,384 particles, step 4,000: 4 variants"
std::string title_of(const SweepIndex& index);

// Throws InputError, naming `where`, unless both are of one state of one scene. Documents without a seed,
// which may be older than it, go with any.
void require_same_state(const std::string& where, const SweepIndex& found, const SweepIndex& expected);

// Throws InputError naming a number that is not finite.
std::string sweep_json(const SweepIndex& index);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
SweepIndex read_sweep(const std::filesystem::path& file);

}  // namespace warpgrain::reports
