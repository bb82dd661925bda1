#pragma once
// Tables of a study that has no variants to rank, format "warpgrain.study/1".
// docs/schemas/study-1.schema.json is its JSON Schema.

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "reports/generator.hpp"

namespace warpgrain::reports {

inline constexpr std::string_view study_format = "warpgrain.study/1";

struct StudyReport {
  using Value = std::variant<std::string, double, std::monostate>;  // monostate: there is none
  struct Table {
    std::string title, note;           // the note may be empty
    std::vector<std::string> columns;  // with their units
    std::vector<std::vector<Value>> rows;
  };

  Generator generator;
  std::string command_line;
  std::string study;
  std::vector<Table> tables;
};

// Throws InputError naming a number that is not finite.
std::string study_json(const StudyReport& report);
// For a terminal, or as Markdown.
std::string text_study(const StudyReport& report);
std::string markdown_study(const StudyReport& report);

}  // namespace warpgrain::reports
