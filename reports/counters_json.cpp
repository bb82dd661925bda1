#include "reports/counters_json.hpp"

#include <array>
#include <fmt/format.h>
#include <nlohmann/json.hpp>
#include <string>

#include "core/error.hpp"
#include "reports/json_place.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;
using profiler::BlockTotals;
using profiler::BranchTotals;
using profiler::InstructionClass;
using profiler::LineTotals;
using profiler::MemoryCounters;
using profiler::Totals;

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

// Calls visit(key, kind, count) for every memory key of the report, in order.
template <class Visit>
void for_each_access(Visit visit) {
  for (const AccessKind& kind : access_kinds)
    for (const AccessCount& count : access_counts)
      if (kind.has_sectors || !count.of_sectors)
        visit(fmt::format("{}_{}", kind.prefix, count.suffix), kind.counters, count.count);
}

InstructionClass class_named(const std::string& where, std::string_view name) {
  std::array<std::string_view, profiler::n_instruction_classes> names;
  for (std::size_t c = 0; c < names.size(); ++c) {
    names[c] = profiler::instruction_class_name(static_cast<InstructionClass>(c));
    if (names[c] == name) return static_cast<InstructionClass>(c);
  }
  throw_unknown_name(where, "instruction class", name, names);
}

std::vector<std::uint64_t> histogram_from(const JsonPlace& place, std::uint32_t warp_width) {
  std::vector<std::uint64_t> histogram = place.counts();
  if (histogram.size() != warp_width + 1u)
    throw_input_error(place.where(), fmt::format("{} entries", histogram.size()),
                      fmt::format("{}, one for each number of active lanes from 0", warp_width + 1));
  return histogram;
}

}  // namespace

Json to_json(const Totals& totals, std::uint32_t warp_width) {
  Json mix = Json::object();  // classes that occur
  for (std::size_t c = 0; c < totals.instruction_mix.size(); ++c) {
    const profiler::InstructionCount& count = totals.instruction_mix[c];
    if (count.warp > 0)
      mix[std::string(profiler::instruction_class_name(static_cast<InstructionClass>(c)))] = {
          {"warp", count.warp}, {"thread", count.thread}};
  }
  Json json{{"warp_instructions", totals.warp_instructions},
            {"thread_instructions", totals.thread_instructions},
            {"active_lanes", totals.active_lanes()},
            {"simt_efficiency", totals.simt_efficiency(warp_width)},
            {"lane_histogram", totals.lane_histogram},
            {"branches", totals.branches},
            {"divergent_branches", totals.divergent_branches},
            {"sfu_instructions", totals.sfu_instructions},
            {"instruction_mix", mix}};
  for_each_access([&](const std::string& key, auto kind, auto count) { json[key] = totals.*kind.*count; });
  return json;
}

Totals totals_from(const JsonPlace& place, std::uint32_t warp_width) {
  Totals totals;
  totals.warp_instructions = place["warp_instructions"].count();
  totals.thread_instructions = place["thread_instructions"].count();
  totals.lane_histogram = histogram_from(place["lane_histogram"], warp_width);
  totals.branches = place["branches"].count();
  totals.divergent_branches = place["divergent_branches"].count();
  totals.sfu_instructions = place["sfu_instructions"].count();
  const JsonPlace mix = place["instruction_mix"];
  for (const auto& [name, count] : mix.members())
    totals.instruction_mix[static_cast<std::size_t>(class_named(mix.where(), name))] = {
        count["warp"].count(), count["thread"].count()};
  for_each_access(
      [&](const std::string& key, auto kind, auto count) { totals.*kind.*count = place[key].count(); });
  return totals;
}

Json to_json(const LineTotals& line, std::uint32_t warp_width) {
  return {{"file", line.file}, {"line", line.line}, {"totals", to_json(line.totals, warp_width)}};
}

LineTotals line_from(const JsonPlace& place, std::uint32_t warp_width) {
  return {place["file"].text(), place["line"].count32(), totals_from(place["totals"], warp_width)};
}

Json to_json(const BranchTotals& branch) {
  return {{"file", branch.file},
          {"line", branch.line},
          {"label", branch.label},
          {"block", branch.block},
          {"executions", branch.executions},
          {"divergent", branch.divergent},
          {"lanes", branch.lanes},
          {"taken_lanes", branch.taken_lanes},
          {"lane_slots_lost", branch.lane_slots_lost}};
}

BranchTotals branch_from(const JsonPlace& place) {
  return {.file = place["file"].text(),
          .line = place["line"].count32(),
          .label = place["label"].text(),
          .block = place["block"].count32(),
          .executions = place["executions"].count(),
          .divergent = place["divergent"].count(),
          .lanes = place["lanes"].count(),
          .taken_lanes = place["taken_lanes"].count(),
          .lane_slots_lost = place["lane_slots_lost"].count()};
}

Json to_json(const BlockTotals& block) {
  return {{"block", block.block},
          {"label", block.label},
          {"executions", block.executions},
          {"lane_histogram", block.lane_histogram}};
}

BlockTotals block_from(const JsonPlace& place, std::uint32_t warp_width) {
  return {.block = place["block"].count32(),
          .label = place["label"].text(),
          .executions = place["executions"].count(),
          .lane_histogram = histogram_from(place["lane_histogram"], warp_width)};
}

}  // namespace warpgrain::reports
