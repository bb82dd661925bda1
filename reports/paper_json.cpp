#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/paper_report.hpp"
#include "reports/state_sample_json.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

Json to_json(const PaperReport::Row& row) {
  Json json{{"section", row.section}, {"quantity", row.quantity}};
  if (!row.unit.empty()) json["unit"] = row.unit;
  if (row.paper) json["paper"] = *row.paper;
  if (row.model) json["model"] = *row.model;
  if (row.simulated) json["simulated"] = *row.simulated;
  json["measured"] = Json::array();
  for (const PaperReport::Measured& measured : row.measured)
    json["measured"].push_back({{"value", measured.value}, {"on", measured.on}});
  if (!row.remark.empty()) json["remark"] = row.remark;
  return json;
}

Json to_json(const PaperReport::Paths& paths) {
  return {{"kernel", paths.kernel},
          {"file", paths.file},
          {"line", paths.line},
          {"branches", paths.branches},
          {"passes", paths.passes},
          {"paths", paths.paths},
          {"instruction_share", paths.instruction_share}};
}

PaperReport::Row paper_row_from(const JsonReader& place) {
  PaperReport::Row row{place.at("section").string(),
                       place.at("quantity").string(),
                       optional_string(place, "unit").value_or(""),
                       optional_number(place, "paper"),
                       optional_number(place, "model"),
                       optional_number(place, "simulated"),
                       {},
                       optional_string(place, "remark").value_or("")};
  for (const JsonReader& measured : place.at("measured").elements())
    row.measured.push_back({measured.at("value").number(), measured.at("on").string()});
  return row;
}

PaperReport::Paths paths_from(const JsonReader& place) {
  return {place.at("kernel").string(),           place.at("file").string(),
          whole_number32(place.at("line")),      whole_number32(place.at("branches")),
          place.at("passes").whole_number(),     place.at("paths").whole_number(),
          place.at("instruction_share").number()};
}

}  // namespace

std::string paper_json(const PaperReport& report) {
  Json json = document_head(paper_format, report.generator, report.command_line);
  json["scene"] = report.scene;
  json["particles"] = report.particles;
  if (report.seed) json["seed"] = *report.seed;
  json["fall"] = {{"steps", report.fall_steps}, {"over", report.fall_is_over}};
  for (const char* key : {"rows", "samples", "paths"}) json[key] = Json::array();
  for (const auto& row : report.rows) json["rows"].push_back(to_json(row));
  for (const auto& sample : report.samples) json["samples"].push_back(to_json(sample));
  for (const auto& paths : report.paths) json["paths"].push_back(to_json(paths));
  return json_text(json, "paper");
}

PaperReport read_paper(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, paper_format);
  PaperReport report;
  report.generator = generator_from(root);
  report.command_line = root.at("command_line").string();
  report.scene = root.at("scene").string();
  report.particles = root.at("particles").whole_number();
  report.seed = optional_whole_number(root, "seed");
  if (const auto fall = root.maybe("fall")) {  // older documents lack it
    report.fall_steps = fall->at("steps").whole_number();
    report.fall_is_over = fall->at("over").boolean();
  }
  for (const JsonReader& row : root.at("rows").elements()) report.rows.push_back(paper_row_from(row));
  report.samples = state_samples_from(root.at("samples"));
  for (const JsonReader& paths : root.at("paths").elements()) report.paths.push_back(paths_from(paths));
  return report;
}

}  // namespace warpgrain::reports
