#include "reports/report_json.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <set>

#include "analysis/sfu_cost.hpp"
#include "reports/bed_json.hpp"
#include "reports/counters_json.hpp"
#include "reports/diagnostics_json.hpp"
#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/modelled_parts_json.hpp"
#include "reports/predicted_times.hpp"
#include "reports/replay_json.hpp"
#include "reports/state_sample_json.hpp"
#include "reports/timeline_json.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

template <class T, class... Options>
Json array_of(const std::vector<T>& values, const Options&... options) {
  Json array = Json::array();
  for (const T& value : values) array.push_back(to_json(value, options...));
  return array;
}

Json machine_json(const Machine& machine) {
  Json json{{"name", machine.name}, {"description", machine.description}};
  if (!machine.arch.empty()) json["arch"] = machine.arch;
  for (const MachineKey& key : machine_keys) {
    const MachineValue& value = machine.*key.value;
    json[std::string(key.key)] = {{"value", value.value}, {"source", value.source}};
    if (key.whole) json[std::string(key.key)]["value"] = static_cast<std::uint64_t>(value.value);
  }
  if (machine.cost)
    for (const CostKey& key : cost_keys) {
      const MachineValue& value = *machine.cost.*key.value;
      json["cost"][std::string(key.key)] = {{"value", value.value}, {"source", value.source}};
    }
  return json;
}

struct FootprintKey {
  std::string_view key;
  std::uint64_t profiler::FootprintCounters::*count;
};
constexpr std::array<FootprintKey, 6> footprint_keys{
    {{"group_load_sectors", &profiler::FootprintCounters::group_load_sectors},
     {"group_store_sectors", &profiler::FootprintCounters::group_store_sectors},
     {"load_sectors", &profiler::FootprintCounters::load_sectors},
     {"store_sectors", &profiler::FootprintCounters::store_sectors},
     {"part_stored_sectors", &profiler::FootprintCounters::part_stored_sectors},
     {"sectors", &profiler::FootprintCounters::sectors}}};

Json sfu_json(const profiler::LaunchCounters& counters, const Machine& machine) {
  const SfuCost cost = sfu_cost(counters.totals, counters.warp_width, machine);
  return {{"instructions", cost.instructions},
          {"serialisation", cost.serialisation},
          {"cycles", cost.cycles},
          {"issue_cycles", cost.issue_cycles},
          {"share", cost.share()}};
}

Json list_making_json(const ListMaking& making) {
  Json json{{"steps_between", making.steps_between},
            {"warp_instructions", making.warp_instructions},
            {"thread_instructions", making.thread_instructions}};
  if (making.predicted_seconds) json["predicted_seconds"] = *making.predicted_seconds;
  return json;
}

ListMaking list_making_from(const JsonReader& place) {
  const ListMaking making{
      place.at("steps_between").whole_number(), place.at("warp_instructions").whole_number(),
      place.at("thread_instructions").whole_number(), optional_number(place, "predicted_seconds")};
  if (making.steps_between == 0) place.at("steps_between").fail("0", "1 or more");
  return making;
}

Json predicted_json(const PredictedTime& time) {
  return {{"seconds", time.seconds}, {"start", time.start},
          {"issue", time.issue},     {"sfu", time.sfu},
          {"lines", time.lines},     {"memory", time.memory},
          {"latency", time.latency}, {"resident_warps", time.resident_warps}};
}

Json launch_json(const Report& report, const LaunchReport& launch, bool with_text) {
  const profiler::LaunchCounters& counters = launch.counters;
  Json source{{"name", launch.source.name},
              {"hash", launch.source.hash},
              {"compiler", launch.source.compiler},
              {"command", launch.source.command}};
  if (with_text) source["text"] = launch.source.text;
  Json ptx{{"hash", launch.ptx.hash}};
  if (!launch.ptx.file.empty()) ptx["file"] = launch.ptx.file;
  Json json{{"kernel", counters.kernel},
            {"global_size", counters.shape.global_size},
            {"local_size", counters.shape.local_size},
            {"shared_bytes", counters.shared_bytes},
            {"warp_width", counters.warp_width},
            {"policy", counters.policy},
            {"replay", to_json(counters.weights)},
            {"warps", counters.warps},
            {"totals", to_json(counters.totals, counters.warp_width)},
            {"lane_slots_never_used", counters.lane_slots_never_used},
            {"branches", array_of(counters.branches, counters)},
            {"lines", array_of(counters.lines, counters.warp_width)},
            {"blocks", array_of(counters.blocks)},
            {"what_if", array_of(counters.what_if)},
            {"timelines", array_of(counters.timelines)},
            {"diagnostics", array_of(counters.diagnostics)},
            {"given_up", counters.given_up},
            {"ptx", ptx},
            {"source", source}};
  if (!counters.weights.asked) json.erase("replay");
  if (counters.timelines.empty()) json.erase("timelines");
  if (counters.footprint)
    for (const FootprintKey& key : footprint_keys)
      json["footprint"][std::string(key.key)] = *counters.footprint.*key.count;
  if (report.machine) json["sfu"] = sfu_json(counters, *report.machine);
  if (const auto predicted = predicted_time(report, launch)) json["predicted"] = predicted_json(*predicted);
  return json;
}

template <class Integer>
std::array<Integer, 3> size_from(const JsonReader& place) {
  const std::vector<std::uint64_t> sizes = whole_numbers(place);
  if (sizes.size() != 3 || std::any_of(sizes.begin(), sizes.end(), [](std::uint64_t size) {
        return size == 0 || size > std::numeric_limits<Integer>::max();
      }))
    place.fail("no size", "three sizes of at least 1");
  return {static_cast<Integer>(sizes[0]), static_cast<Integer>(sizes[1]), static_cast<Integer>(sizes[2])};
}

// Sources of earlier launches by hash; texts stand once in a report.
using Texts = std::map<std::string, std::string>;

SourceText source_from(const JsonReader& place, Texts& texts) {
  SourceText source{.name = place.at("name").string(),
                    .text = {},
                    .hash = place.at("hash").string(),
                    .compiler = place.at("compiler").string(),
                    .command = place.at("command").string()};
  if (const auto text = optional_string(place, "text")) texts[source.hash] = *text;
  const auto found = texts.find(source.hash);
  if (found == texts.end())
    place.fail("'text' is missing", "it, as no launch before has a source of this hash");
  source.text = found->second;
  return source;
}

LaunchReport launch_from(const JsonReader& place, Texts& texts) {
  LaunchReport launch;
  profiler::LaunchCounters& counters = launch.counters;
  counters.kernel = place.at("kernel").string();
  counters.shape.global_size = size_from<std::uint64_t>(place.at("global_size"));
  counters.shape.local_size = size_from<std::uint32_t>(place.at("local_size"));
  // Older reports lack it.
  if (const auto shared = place.maybe("shared_bytes")) counters.shared_bytes = shared->whole_number();
  counters.warp_width = warp_width_from(place.at("warp_width"));
  counters.policy = place.at("policy").string();
  if (const auto replay = place.maybe("replay")) counters.weights = weights_from(*replay);
  counters.warps = place.at("warps").whole_number();
  counters.totals = totals_from(place.at("totals"), counters.warp_width);
  if (const auto footprint = place.maybe("footprint")) {
    counters.footprint.emplace();
    for (const FootprintKey& key : footprint_keys)
      *counters.footprint.*key.count = footprint->at(key.key).whole_number();
  }
  counters.lane_slots_never_used = place.at("lane_slots_never_used").whole_number();
  for (const JsonReader& branch : place.at("branches").elements())
    counters.branches.push_back(branch_from(branch));
  for (const JsonReader& line : place.at("lines").elements())
    counters.lines.push_back(line_from(line, counters.warp_width));
  for (const JsonReader& block : place.at("blocks").elements())
    counters.blocks.push_back(block_from(block, counters.warp_width));
  for (const profiler::BranchTotals& branch : counters.branches)
    if (branch.block >= counters.blocks.size())
      place.at("branches")
          .fail(fmt::format("a branch of block {}", branch.block),
                fmt::format("less than {} blocks", counters.blocks.size()));
  for (const JsonReader& answer : place.at("what_if").elements())
    counters.what_if.push_back(what_if_from(answer));
  // Where none was asked for, and in older reports, there are none.
  if (const auto timelines = place.maybe("timelines"))
    for (const JsonReader& timeline : timelines->elements())
      counters.timelines.push_back(timeline_from(timeline, counters.blocks.size(), counters.warp_width));
  launch.ptx = {place.at("ptx").at("hash").string(), optional_string(place.at("ptx"), "file").value_or("")};
  // Reports of programs that did not check have neither key.
  if (const auto diagnostics = place.maybe("diagnostics"))
    for (const JsonReader& diagnostic : diagnostics->elements())
      counters.diagnostics.push_back(diagnostic_from(diagnostic));
  if (const auto given_up = place.maybe("given_up")) counters.given_up = given_up->boolean();
  launch.source = source_from(place.at("source"), texts);
  return launch;
}

}  // namespace

std::string report_json(const Report& report) {
  Json json = document_head(report_format, report.generator, report.command_line);
  if (report.scene) json["scene"] = *report.scene;
  if (report.variant) json["variant"] = *report.variant;
  add_modelled_parts(json, report.model);
  if (report.particles) json["particles"] = *report.particles;
  if (report.seed) json["seed"] = *report.seed;
  if (report.step) json["step"] = *report.step;
  if (report.machine) json["machine"] = machine_json(*report.machine);
  json["weights"] = report.weights;
  json["buffer_bytes"] = report.buffer_bytes;
  if (report.touched_bytes) json["touched_bytes"] = *report.touched_bytes;
  if (report.list_making) json["list_making"] = list_making_json(*report.list_making);
  json["limits"] = report.limits;
  json["launches"] = Json::array();
  std::set<std::string> written;
  for (const LaunchReport& launch : report.launches)
    json["launches"].push_back(launch_json(report, launch, written.insert(launch.source.hash).second));
  if (!report.samples.empty()) json["samples"] = array_of(report.samples);
  if (report.bed) json["bed"] = to_json(*report.bed);
  return json_text(json, "report");
}

Report read_report(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, report_format);
  Report report;
  report.generator = generator_from(root);
  report.command_line = root.at("command_line").string();
  report.scene = optional_string(root, "scene");
  if (root.maybe("variant")) report.variant = variant_from(root);
  report.model = modelled_parts_from(root);
  report.particles = optional_whole_number(root, "particles");
  report.seed = optional_whole_number(root, "seed");
  report.step = optional_whole_number(root, "step");
  if (const auto samples = root.maybe("samples")) report.samples = state_samples_from(*samples);
  if (const auto machine = root.maybe("machine")) report.machine = machine_from(*machine);
  if (const auto bed = root.maybe("bed")) report.bed = bed_from(*bed);
  report.weights = root.at("weights").string();
  // Older reports lack it.
  report.buffer_bytes = optional_whole_number(root, "buffer_bytes").value_or(0);
  report.touched_bytes = optional_whole_number(root, "touched_bytes");
  if (const auto making = root.maybe("list_making")) report.list_making = list_making_from(*making);
  for (const JsonReader& limit : root.at("limits").elements()) report.limits.push_back(limit.string());
  Texts texts;
  for (const JsonReader& launch : root.at("launches").elements())
    report.launches.push_back(launch_from(launch, texts));
  return report;
}

}  // namespace warpgrain::reports
