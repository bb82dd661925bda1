#pragma once
// The paper's tables and figures beside what is computed, simulated and measured, format "warpgrain.paper/1".
// docs/schemas/paper-1.schema.json is its JSON Schema.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/generator.hpp"
#include "reports/state_sample.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view paper_format = "warpgrain.paper/1";

struct PaperReport {
  struct Measured {
    double value = 0;
    std::string on;  // "here: " or a file's name, and the device
  };
  struct Row {
    std::string section;   // of the paper: "Table 3", "eq. (13)", "section 6"
    std::string quantity;  // "simple model, CUDA"
    std::string unit;      // empty: a ratio or a count
    std::optional<double> paper, model, simulated;
    std::vector<Measured> measured;
    std::string remark;  // what the values are, where that is not plain
  };
  // A body of a loop, or of the kernel outside of loops.
  struct Paths {
    std::string kernel, file;
    std::uint32_t line = 0;
    std::uint32_t branches = 0;
    std::uint64_t passes = 0, paths = 0;
    double instruction_share = 0;  // of all instructions that lanes ran
  };

  Generator generator;
  std::string command_line;
  std::string scene;
  std::uint64_t particles = 0;
  std::optional<std::uint64_t> seed;  // of the fill
  std::uint64_t fall_steps = 0;       // how far the particles have fallen
  bool fall_is_over = true;           // else Ctrl-C has ended it, and there are no rows yet
  std::vector<Row> rows;
  std::vector<StateSample> samples;  // in order of time
  std::vector<Paths> paths;          // of the step's heaviest kernel
};

// Throws InputError naming a number that is not finite.
std::string paper_json(const PaperReport& report);

// Throws InputError naming the file and the place of what is missing, wrong or of another format or version.
PaperReport read_paper(const std::filesystem::path& file);

// Tables for a terminal.
std::string text_paper(const PaperReport& report);

}  // namespace warpgrain::reports
