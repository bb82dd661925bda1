#include "reports/diagnostics_json.hpp"

#include <algorithm>
#include <nlohmann/json.hpp>
#include <vector>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;
using profiler::Diagnostic;
using profiler::DiagnosticKind;
using profiler::DiagnosticPlace;

void put_place(Json& json, const DiagnosticPlace& place) {
  json["file"] = place.file;
  json["line"] = place.line;
  json["ptx_line"] = place.ptx_line;
}

DiagnosticPlace place_from(const JsonReader& json) {
  return {json.at("file").string(), whole_number32(json.at("line")), whole_number32(json.at("ptx_line"))};
}

std::array<std::uint64_t, 3> id_from(const JsonReader& json) {
  const std::vector<std::uint64_t> id = whole_numbers(json);
  if (id.size() != 3) json.fail("no id", "three whole numbers");
  return {id[0], id[1], id[2]};
}

DiagnosticKind kind_from(const JsonReader& json) {
  std::vector<std::string_view> names;
  for (std::size_t k = 0; k < static_cast<std::size_t>(DiagnosticKind::count); ++k)
    names.push_back(diagnostic_kind_name(static_cast<DiagnosticKind>(k)));
  return static_cast<DiagnosticKind>(json.one_of(names, "kind"));
}

}  // namespace

Json to_json(const Diagnostic& d) {
  Json json{{"kind", diagnostic_kind_name(d.kind)}};
  put_place(json, d.place);
  json["work_item"] = d.work_item;
  json["work_group"] = d.work_group;
  if (!d.access.empty()) {
    json["access"] = d.access;
    json["space"] = d.space;
    json["bytes"] = d.bytes;
  }
  if (!d.buffer.empty()) {
    json["buffer"] = d.buffer;
    json["offset"] = d.offset;
    json["buffer_bytes"] = d.buffer_bytes;
  }
  if (!d.detail.empty()) json["detail"] = d.detail;
  if (d.other) {
    Json& other = json["other"];
    put_place(other, d.other->place);
    other["access"] = d.other->access;
    if (d.other->work_item) other["work_item"] = *d.other->work_item;
  }
  json["count"] = d.count;
  return json;
}

Diagnostic diagnostic_from(const JsonReader& json) {
  Diagnostic d;
  d.kind = kind_from(json.at("kind"));
  d.place = place_from(json);
  d.work_item = id_from(json.at("work_item"));
  d.work_group = id_from(json.at("work_group"));
  if (json.has("access")) {
    d.access = json.at("access").string();
    d.space = json.at("space").string();
    d.bytes = whole_number32(json.at("bytes"));
  }
  if (json.has("buffer")) {
    d.buffer = json.at("buffer").string();
    d.offset = static_cast<std::int64_t>(json.at("offset").number());
    d.buffer_bytes = json.at("buffer_bytes").whole_number();
  }
  d.detail = optional_string(json, "detail").value_or("");
  if (const auto other = json.maybe("other")) {
    d.other.emplace();
    d.other->place = place_from(*other);
    d.other->access = other->at("access").string();
    if (const auto item = other->maybe("work_item")) d.other->work_item = id_from(*item);
  }
  d.count = json.at("count").count();
  return d;
}

}  // namespace warpgrain::reports
