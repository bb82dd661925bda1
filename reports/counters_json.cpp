#include "reports/counters_json.hpp"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;
using profiler::BlockTotals;
using profiler::BranchTotals;
using profiler::InstructionClass;
using profiler::LineTotals;
using profiler::MemoryCounters;
using profiler::Totals;
using profiler::WhatIfTotals;

// A kind of access under its key's prefix. Shared memory has banks, not sectors, so sectors and 128-byte
// lines are of global memory and of atomics alone.
struct AccessKind {
  const char* prefix;
  MemoryCounters Totals::*counters;
  bool has_sectors;
};
constexpr std::array<AccessKind, 5> access_kinds{{{"global_load", &Totals::global_load, true},
                                                  {"global_store", &Totals::global_store, true},
                                                  {"shared_load", &Totals::shared_load, false},
                                                  {"shared_store", &Totals::shared_store, false},
                                                  {"atomic", &Totals::atomic, true}}};

struct AccessCount {
  const char* suffix;
  std::uint64_t MemoryCounters::*count;
  bool of_sectors;
};
constexpr std::array<AccessCount, 4> access_counts{{{"requests", &MemoryCounters::requests, false},
                                                    {"sectors", &MemoryCounters::sectors, true},
                                                    {"lines", &MemoryCounters::lines, true},
                                                    {"useful_bytes", &MemoryCounters::useful_bytes, false}}};

// Quotients that tell how well requests coalesce; absent without requests.
void add_request_ratios(Json& json, const Totals& totals) {
  for (const AccessKind& kind : access_kinds) {
    const MemoryCounters& access = totals.*kind.counters;
    if (!kind.has_sectors || access.requests == 0) continue;
    json[fmt::format("{}_sectors_per_request", kind.prefix)] = access.sectors_per_request();
    json[fmt::format("{}_lines_per_request", kind.prefix)] = access.lines_per_request();
    json[fmt::format("{}_efficiency", kind.prefix)] = access.efficiency();
  }
}

// Calls visit(key, kind, count) for every memory key of the report, in order.
template <class Visit>
void for_each_access(Visit visit) {
  for (const AccessKind& kind : access_kinds)
    for (const AccessCount& count : access_counts)
      if (kind.has_sectors || !count.of_sectors)
        visit(fmt::format("{}_{}", kind.prefix, count.suffix), kind.counters, count.count);
}

void require_sums(const JsonReader& place, std::uint64_t warp, std::uint64_t thread, const Totals& totals) {
  if (warp != totals.warp_instructions || thread != totals.thread_instructions)
    place.fail(fmt::format("adds up to {} warp and {} thread instructions", warp, thread),
               fmt::format("{} and {}", totals.warp_instructions, totals.thread_instructions));
}

// Every instruction is of one class: a mix that adds up to something else holds an unknown class or was cut.
void read_mix(const JsonReader& mix, Totals& totals) {
  std::uint64_t warp = 0, thread = 0;
  for (std::size_t c = 0; c < totals.instruction_mix.size(); ++c) {
    const auto count = mix.maybe(profiler::instruction_class_name(static_cast<InstructionClass>(c)));
    if (!count) continue;
    totals.instruction_mix[c] = {count->at("warp").whole_number(), count->at("thread").whole_number()};
    warp += totals.instruction_mix[c].warp;
    thread += totals.instruction_mix[c].thread;
  }
  require_sums(mix, warp, thread, totals);
}

// Of the lanes of a pool nothing is known but how many ran each block.
TotalsParts parts_of(const WhatIfTotals& answer) {
  return {.lanes = answer.pool == 0, .requests = answer.has_requests};
}

std::vector<std::uint64_t> histogram_from(const JsonReader& place, std::uint32_t warp_width) {
  std::vector<std::uint64_t> histogram = whole_numbers(place);
  if (histogram.size() != warp_width + 1u)
    place.fail(fmt::format("{} entries", histogram.size()),
               fmt::format("{}, one for each number of active lanes from 0", warp_width + 1));
  return histogram;
}

void read_lanes(const JsonReader& place, std::uint32_t warp_width, Totals& totals) {
  totals.lane_histogram = histogram_from(place.at("lane_histogram"), warp_width);
  std::uint64_t warp = 0, thread = 0;
  for (std::size_t lanes = 0; lanes <= warp_width; ++lanes) {
    warp += totals.lane_histogram[lanes];
    thread += lanes * totals.lane_histogram[lanes];
  }
  require_sums(place.at("lane_histogram"), warp, thread, totals);
  totals.branches = place.at("branches").whole_number();
  totals.divergent_branches = place.at("divergent_branches").whole_number();
}

}  // namespace

Json to_json(const Totals& totals, std::uint32_t warp_width, TotalsParts parts) {
  Json mix = Json::object();  // classes that occur
  for (std::size_t c = 0; c < totals.instruction_mix.size(); ++c) {
    const profiler::InstructionCount& count = totals.instruction_mix[c];
    if (count.warp > 0)
      mix[std::string(profiler::instruction_class_name(static_cast<InstructionClass>(c)))] = {
          {"warp", count.warp}, {"thread", count.thread}};
  }
  Json json{{"warp_instructions", totals.warp_instructions},
            {"thread_instructions", totals.thread_instructions}};
  if (totals.thread_instructions_pred_on != 0)
    json["thread_instructions_pred_on"] = totals.thread_instructions_pred_on;
  json["active_lanes"] = totals.active_lanes();
  json["simt_efficiency"] = totals.simt_efficiency(warp_width);
  if (parts.lanes) {
    json["lane_histogram"] = totals.lane_histogram;
    json["branches"] = totals.branches;
    json["divergent_branches"] = totals.divergent_branches;
  }
  json["sfu_instructions"] = totals.sfu_instructions;
  json["instruction_mix"] = mix;
  if (parts.requests) {
    for_each_access([&](const std::string& key, auto kind, auto count) { json[key] = totals.*kind.*count; });
    add_request_ratios(json, totals);
  }
  return json;
}

Totals totals_from(const JsonReader& place, std::uint32_t warp_width, TotalsParts parts) {
  Totals totals;
  totals.warp_instructions = place.at("warp_instructions").whole_number();
  totals.thread_instructions = place.at("thread_instructions").whole_number();
  totals.thread_instructions_pred_on =
      optional_whole_number(place, "thread_instructions_pred_on").value_or(0);
  if (parts.lanes) read_lanes(place, warp_width, totals);
  totals.sfu_instructions = place.at("sfu_instructions").whole_number();
  read_mix(place.at("instruction_mix"), totals);
  if (parts.requests)
    for_each_access([&](const std::string& key, auto kind, auto count) {
      totals.*kind.*count = place.at(key).whole_number();
    });
  return totals;
}

Json to_json(const LineTotals& line, std::uint32_t warp_width) {
  return {{"file", line.file},
          {"line", line.line},
          {"lane_slots_idle", line.totals.lane_slots_idle(warp_width)},
          {"totals", to_json(line.totals, warp_width)}};
}

LineTotals line_from(const JsonReader& place, std::uint32_t warp_width) {
  return {place.at("file").string(), whole_number32(place.at("line")),
          totals_from(place.at("totals"), warp_width)};
}

Json to_json(const BranchTotals& branch, const profiler::LaunchCounters& launch) {
  const std::uint64_t all = launch.totals.lane_slots_idle(launch.warp_width);
  return {
      {"file", branch.file},
      {"line", branch.line},
      {"label", branch.label},
      {"block", branch.block},
      {"executions", branch.executions},
      {"divergent", branch.divergent},
      {"lanes", branch.lanes},
      {"taken_lanes", branch.taken_lanes},
      {"lane_slots_lost", branch.lane_slots_lost},
      {"loss_share", all == 0 ? 0.0 : static_cast<double>(branch.lane_slots_lost) / static_cast<double>(all)},
      {"lane_histogram", launch.blocks.at(branch.block).lane_histogram}};
}

BranchTotals branch_from(const JsonReader& place) {
  return {.file = place.at("file").string(),
          .line = whole_number32(place.at("line")),
          .label = place.at("label").string(),
          .block = whole_number32(place.at("block")),
          .executions = place.at("executions").whole_number(),
          .divergent = place.at("divergent").whole_number(),
          .lanes = place.at("lanes").whole_number(),
          .taken_lanes = place.at("taken_lanes").whole_number(),
          .lane_slots_lost = place.at("lane_slots_lost").whole_number()};
}

Json to_json(const BlockTotals& block) {
  Json json{{"block", block.block},
            {"label", block.label},
            {"instructions", block.instructions},
            {"executions", block.executions},
            {"divergent", block.divergent},
            {"lane_slots_idle", block.lane_slots_idle()},
            {"lane_histogram", block.lane_histogram}};
  if (block.line != 0) {
    json["file"] = block.file;
    json["line"] = block.line;
  }
  return json;
}

BlockTotals block_from(const JsonReader& place, std::uint32_t warp_width) {
  return {.block = whole_number32(place.at("block")),
          .label = place.at("label").string(),
          .instructions = place.at("instructions").whole_number(),
          .executions = place.at("executions").whole_number(),
          .divergent = place.at("divergent").whole_number(),
          .lane_histogram = histogram_from(place.at("lane_histogram"), warp_width),
          // Older reports lack both.
          .file = optional_string(place, "file").value_or(""),
          .line = place.has("line") ? whole_number32(place.at("line")) : 0};
}

Json to_json(const WhatIfTotals& answer) {
  Json json{{"warp_width", answer.warp_width}};
  if (!answer.policy.empty()) json["policy"] = answer.policy;
  json["order"] = answer.order;
  if (answer.pool != 0) json["pool"] = answer.pool;
  if (answer.pool == 0) json["warps"] = answer.warps;
  if (!answer.remark.empty()) json["remark"] = answer.remark;
  json["totals"] = to_json(answer.totals, answer.warp_width, parts_of(answer));
  return json;
}

WhatIfTotals what_if_from(const JsonReader& place) {
  WhatIfTotals answer;
  answer.warp_width = warp_width_from(place.at("warp_width"));
  answer.order = place.at("order").string();
  if (const auto pool = place.maybe("pool")) {
    answer.pool = whole_number32(*pool);
  } else {
    answer.policy = place.at("policy").string();
    answer.warps = place.at("warps").whole_number();
  }
  if (const auto remark = optional_string(place, "remark")) answer.remark = *remark;
  answer.has_requests = place.at("totals").has("global_load_requests");
  answer.totals = totals_from(place.at("totals"), answer.warp_width, parts_of(answer));
  return answer;
}

std::uint32_t warp_width_from(const JsonReader& place) {
  const std::uint32_t width = whole_number32(place);
  if (width == 0 || width > 64) place.fail(fmt::format("{}", width), "1 to 64");
  return width;
}

}  // namespace warpgrain::reports
