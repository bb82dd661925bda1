#pragma once
// Timings and counters that a real device gave, format "warpgrain.measured/1".
// docs/schemas/measured-1.schema.json is its JSON Schema.

#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"
#include "reports/modelled_parts.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view measured_format = "warpgrain.measured/1";

struct MeasuredReport {
  struct Device {
    std::string name;
    std::string architecture;  // "sm_90"; empty where the back end does not tell
    std::string driver;
  };
  // What the assembler made of a kernel.
  struct Code {
    std::string assembler;  // and its version
    std::string ptx_hash;   // text_hash of the PTX of the front end, as in reports
    std::uint64_t registers = 0;
    std::uint64_t shared_bytes = 0;  // of a work-group
    std::uint64_t local_bytes = 0;   // of a work-item
  };
  // A buffer after the run, held against what the simulator leaves in it.
  struct Agreement {
    std::string argument;
    std::uint64_t elements = 0, differing = 0;  // differing: not the same bytes
    // Of floating-point numbers: the largest difference, in parts of the largest number of the buffer.
    double largest_difference = 0;
  };
  struct Kernel {
    std::string kernel;
    std::string launch_file;  // empty for a kernel of a scene's step
    std::optional<std::array<std::uint64_t, 3>> global_size;
    std::optional<std::array<std::uint64_t, 3>> local_size;
    std::uint64_t calls = 1;      // that a reading stands for
    std::vector<double> seconds;  // a reading each, of all calls together
    std::optional<Code> code;
    std::vector<Agreement> agreement;
    std::map<std::string, double> counters;  // by the names of report totals
  };
  struct Step {
    std::uint64_t steps = 1;      // that a reading is the mean of
    std::vector<double> seconds;  // of one step, a reading each
  };

  Generator generator;
  std::string command_line;
  std::string backend;
  Device device;
  std::optional<std::string> scene, variant;
  ModelledParts model;
  std::optional<std::uint64_t> particles, seed;  // seed: of the scene's fill
  std::optional<Step> step;
  std::vector<Kernel> kernels;
};

// Throws InputError naming a number that is not finite.
std::string measured_json(const MeasuredReport& measured);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
MeasuredReport read_measured(const std::filesystem::path& file);

}  // namespace warpgrain::reports
