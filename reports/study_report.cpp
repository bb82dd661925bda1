#include "reports/study_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {
namespace {

std::string study_value_text(const StudyReport::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return fmt::format("{:.5g}", *number);
  return "-";
}

nlohmann::ordered_json study_value_json(const StudyReport::Value& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* number = std::get_if<double>(&value)) return *number;
  return "";
}

}  // namespace

std::string study_json(const StudyReport& report) {
  nlohmann::ordered_json json = document_head(study_format, report.generator, report.command_line);
  json["study"] = report.study;
  json["tables"] = nlohmann::ordered_json::array();
  for (const StudyReport::Table& table : report.tables) {
    nlohmann::ordered_json rows = nlohmann::ordered_json::array();
    for (const auto& row : table.rows) {
      rows.push_back(nlohmann::ordered_json::array());
      for (const StudyReport::Value& value : row) rows.back().push_back(study_value_json(value));
    }
    json["tables"].push_back(
        {{"title", table.title}, {"note", table.note}, {"columns", table.columns}, {"rows", rows}});
  }
  return json_text(json, "study");
}

std::string text_study(const StudyReport& report) {
  std::string text;
  for (const StudyReport::Table& table : report.tables) {
    std::vector<TextTable::Column> columns;
    for (const std::string& name : table.columns)
      columns.push_back({name, columns.empty() ? TextTable::Align::left : TextTable::Align::right});
    TextTable lines(columns);
    for (const auto& row : table.rows) {
      std::vector<std::string> cells;
      for (const StudyReport::Value& value : row) cells.push_back(study_value_text(value));
      lines.add_row(cells);
    }
    text += fmt::format("{}{}\n\n{}", text.empty() ? "" : "\n", table.title, lines.text());
    if (!table.note.empty()) text += fmt::format("{}\n", table.note);
  }
  return text;
}

std::string markdown_study(const StudyReport& report) {
  std::string text;
  for (const StudyReport::Table& table : report.tables) {
    text += fmt::format("{}{}:\n\n|", text.empty() ? "" : "\n", table.title);
    for (const std::string& name : table.columns) text += fmt::format(" {} |", name);
    text += "\n|";
    for (std::size_t k = 0; k < table.columns.size(); ++k) text += k == 0 ? "---|" : "---:|";
    text += "\n";
    for (const auto& row : table.rows) {
      text += "|";
      for (const StudyReport::Value& value : row) text += fmt::format(" {} |", study_value_text(value));
      text += "\n";
    }
    if (!table.note.empty()) text += fmt::format("\n{}\n", table.note);
  }
  return text;
}

}  // namespace warpgrain::reports
