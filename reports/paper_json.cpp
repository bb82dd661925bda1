#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/paper_report.hpp"

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

Json to_json(const PaperReport::Sample& sample) {
  Json json{{"step", sample.step},
            {"time", sample.time},
            {"mean_candidates", sample.mean_candidates},
            {"most_candidates", sample.most_candidates},
            {"mean_contacts", sample.mean_contacts},
            {"most_contacts", sample.most_contacts},
            {"kernels", Json::array()}};
  for (const PaperReport::Sample::Kernel& kernel : sample.kernels)
    json["kernels"].push_back({{"kernel", kernel.kernel},
                               {"warp_instructions", kernel.warp_instructions},
                               {"simt_efficiency", kernel.simt_efficiency}});
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

}  // namespace

std::string paper_json(const PaperReport& report) {
  Json json = document_head(paper_format, report.generator, report.command_line);
  json["scene"] = report.scene;
  json["particles"] = report.particles;
  for (const char* key : {"rows", "samples", "paths"}) json[key] = Json::array();
  for (const auto& row : report.rows) json["rows"].push_back(to_json(row));
  for (const auto& sample : report.samples) json["samples"].push_back(to_json(sample));
  for (const auto& paths : report.paths) json["paths"].push_back(to_json(paths));
  return json_text(json, "paper");
}

}  // namespace warpgrain::reports
