#pragma once
// What a run of a scene gave, format "warpgrain.run/1": timings, energies over time, contacts.
// docs/schemas/run-1.schema.json is its JSON Schema.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"
#include "reports/modelled_parts.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view run_format = "warpgrain.run/1";

// Which condition ended the run: the number of steps, the simulated time, all particles at rest, or Ctrl-C.
enum class RunEndReason : std::uint8_t { steps, time, at_rest, interrupted };

struct RunReport {
  struct Kernel {
    std::string name;
    std::uint64_t calls = 0;
    double seconds = 0;  // sum over the calls
  };
  // Energies of all particles together [J].
  struct Energy {
    std::uint64_t step = 0;
    double time = 0;           // s
    double translational = 0;  // sum of m v^2 / 2
    double rotational = 0;     // sum of I w^2 / 2
    double gravitational = 0;  // - sum of m g.x
    double elastic = 0;        // stored in the springs of the contacts, normal and tangential
    double total() const { return translational + rotational + gravitational + elastic; }
  };

  Generator generator;
  std::string command_line;
  std::string scene, variant, backend;
  std::string device;  // as it calls itself
  ModelledParts model;
  std::uint64_t particles = 0;
  std::optional<std::uint64_t> seed;  // of the scene's fill
  std::uint64_t steps = 0;
  double time_step = 0;  // s
  RunEndReason ended_by = RunEndReason::steps;
  double wall_seconds = 0;  // of the steps alone: no building, no reading, no writing
  std::vector<Kernel> kernels;
  std::vector<Energy> energy;  // in order of time
  std::uint64_t contacts = 0;  // touching at the end: a pair once, a wall contact once

  // particles * steps / wall_seconds, the paper's "particles/s"; 0 for a run without steps.
  double particle_steps_per_second() const;
};

// Throws InputError naming a number that is not finite.
std::string run_json(const RunReport& run);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
RunReport read_run(const std::filesystem::path& file);

}  // namespace warpgrain::reports
