#include <array>
#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/modelled_parts_json.hpp"
#include "reports/run_report.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array<std::string_view, 4> end_names{"steps", "time", "at_rest", "interrupted"};

Json to_json(const RunReport::Kernel& kernel) {
  return {{"name", kernel.name}, {"calls", kernel.calls}, {"seconds", kernel.seconds}};
}

RunReport::Kernel kernel_from(const JsonReader& place) {
  return {place.at("name").string(), place.at("calls").whole_number(), place.at("seconds").number()};
}

Json to_json(const RunReport::Energy& energy) {
  return {{"step", energy.step},
          {"time", energy.time},
          {"translational", energy.translational},
          {"rotational", energy.rotational},
          {"gravitational", energy.gravitational},
          {"elastic", energy.elastic},
          {"total", energy.total()}};
}

RunReport::Energy energy_from(const JsonReader& place) {
  return {.step = place.at("step").whole_number(),
          .time = place.at("time").number(),
          .translational = place.at("translational").number(),
          .rotational = place.at("rotational").number(),
          .gravitational = place.at("gravitational").number(),
          .elastic = place.at("elastic").number()};
}

}  // namespace

double RunReport::particle_steps_per_second() const {
  return steps == 0 ? 0 : static_cast<double>(particles) * static_cast<double>(steps) / wall_seconds;
}

std::string run_json(const RunReport& run) {
  Json json = document_head(run_format, run.generator, run.command_line);
  json["scene"] = run.scene;
  json["variant"] = run.variant;
  json["backend"] = run.backend;
  json["device"] = run.device;
  add_modelled_parts(json, run.model);
  json["particles"] = run.particles;
  if (run.seed) json["seed"] = *run.seed;
  json["steps"] = run.steps;
  json["time_step"] = run.time_step;
  json["ended_by"] = end_names[static_cast<std::size_t>(run.ended_by)];
  json["wall_seconds"] = run.wall_seconds;
  json["particle_steps_per_second"] = run.particle_steps_per_second();
  json["contacts"] = run.contacts;
  json["kernels"] = Json::array();
  for (const RunReport::Kernel& kernel : run.kernels) json["kernels"].push_back(to_json(kernel));
  json["energy"] = Json::array();
  for (const RunReport::Energy& energy : run.energy) json["energy"].push_back(to_json(energy));
  return json_text(json, "run");
}

RunReport read_run(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, run_format);
  RunReport run;
  run.generator = generator_from(root);
  run.command_line = root.at("command_line").string();
  run.scene = root.at("scene").string();
  run.variant = variant_from(root);
  run.model = modelled_parts_from(root);
  run.backend = root.at("backend").string();
  run.device = root.at("device").string();
  run.particles = root.at("particles").whole_number();
  run.seed = optional_whole_number(root, "seed");
  run.steps = root.at("steps").whole_number();
  run.time_step = root.at("time_step").number();
  run.ended_by = static_cast<RunEndReason>(root.at("ended_by").one_of(end_names, "end of a run"));
  run.wall_seconds = root.at("wall_seconds").number();
  run.contacts = root.at("contacts").whole_number();
  for (const JsonReader& kernel : root.at("kernels").elements()) run.kernels.push_back(kernel_from(kernel));
  for (const JsonReader& energy : root.at("energy").elements()) run.energy.push_back(energy_from(energy));
  return run;
}

}  // namespace warpgrain::reports
