#pragma once
// What each variant costs and how far it is off, format "warpgrain.accuracy/1".
// docs/schemas/accuracy-1.schema.json is its JSON Schema.

#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view accuracy_format = "warpgrain.accuracy/1";

// What a step can cost, each a member of AccuracyReport::Case.
inline constexpr std::array<std::string_view, 5> cost_names{"warp_instructions", "bytes", "seconds",
                                                            "predicted_seconds", "measured_seconds"};

struct AccuracyReport {
  struct Force {
    double maximum = 0, root_mean_square = 0;            // of the largest force
    double maximum_ulps = 0, root_mean_square_ulps = 0;  // of floats at the largest force
  };
  struct Collision {
    double restitution = 0;    // as a part of the speed of impact
    double rebound_angle = 0;  // degrees
    double spin = 0;           // surface speed, as a part of the speed of impact
  };
  struct Trajectory {
    std::optional<double> parted_at;  // s; none: not within `compared`
    double compared = 0;              // s
    double distance = 0;              // rms at the end of the comparison, in radii
  };
  // One quantity over seeds.
  struct Ensemble {
    std::string quantity, unit;
    double mean = 0;
    std::optional<double> half_width;  // of the 95 % interval
    // Of the mean from the reference's, with its own interval; none of the reference.
    std::optional<double> difference, difference_half_width;
    bool significant = false;
  };
  struct Case {
    std::string variant;
    double step_factor = 1;
    std::string backend;                  // where the errors are from
    std::uint64_t warp_instructions = 0;  // of a step
    std::uint64_t bytes = 0;
    std::optional<double> seconds;            // of a step on the OpenCL device
    std::optional<double> predicted_seconds;  // on the machine
    std::optional<double> measured_seconds;   // as `measured` says
    // For the same time simulated, in the first case's that has one, by the criterion; 0: there is none.
    double relative_cost = 0;
    std::optional<Force> force;
    std::optional<Collision> collision;
    std::optional<Trajectory> trajectory;
    std::vector<Ensemble> ensemble;
    // The case that is at most as costly and as far off in every criterion, and less so in one; none for
    // those of the front.
    std::optional<std::string> dominated_by;
    std::string failure;  // the line that it ended with; the rest stands as far as it came
    std::string name() const;
  };

  Generator generator;
  std::string command_line;
  std::string scene;
  std::uint64_t particles = 0, step = 0;
  double time_step = 0;                    // s
  std::optional<std::uint64_t> seed;       // of the scene's fill
  std::uint64_t seeds = 0;                 // of the ensembles: 1 to this
  std::string cost = "warp_instructions";  // of cost_names
  std::uint64_t cost_particles = 0;        // of the scene that costs were counted of
  std::string machine;                     // its name; empty: none
  std::string measured;                    // device, scene and particles; empty: nothing was
  std::vector<Case> cases;
};

// Fills relative_cost and dominated_by of all cases. What was not measured of any case is no criterion.
void rank_cases(AccuracyReport& report);

// "costs 0.41 x, restitution off by 3e-4 of the speed, packing fraction unchanged within 0.2 %"
std::string sentence_of(const AccuracyReport::Case& row);

// Throws InputError naming a number that is not finite.
std::string accuracy_json(const AccuracyReport& report);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
AccuracyReport read_accuracy(const std::filesystem::path& file);

// For a terminal: the table, and a sentence a case.
std::string text_accuracy(const AccuracyReport& report);

}  // namespace warpgrain::reports
