#include <nlohmann/json.hpp>

#include "analysis/statistics.hpp"
#include "reports/json_fields.hpp"
#include "reports/json_text.hpp"
#include "reports/measured_report.hpp"
#include "reports/modelled_parts_json.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;

Json seconds_json(const std::vector<double>& seconds) {
  const Spread spread = spread_of(seconds);
  return {{"median", spread.median},
          {"minimum", spread.minimum},
          {"lower_quartile", spread.lower_quartile},
          {"upper_quartile", spread.upper_quartile},
          {"maximum", spread.maximum},
          {"readings", seconds}};
}

std::vector<double> seconds_from(const JsonReader& place) {
  std::vector<double> seconds;
  for (const JsonReader& reading : place.at("readings").elements()) seconds.push_back(reading.number());
  if (seconds.empty()) place.at("readings").fail("no reading", "one or more");
  return seconds;
}

Json to_json(const MeasuredReport::Code& code) {
  return {{"assembler", code.assembler},
          {"ptx_hash", code.ptx_hash},
          {"registers", code.registers},
          {"shared_bytes", code.shared_bytes},
          {"local_bytes", code.local_bytes}};
}

MeasuredReport::Code code_from(const JsonReader& place) {
  return {place.at("assembler").string(), place.at("ptx_hash").string(), place.at("registers").whole_number(),
          place.at("shared_bytes").whole_number(), place.at("local_bytes").whole_number()};
}

Json to_json(const MeasuredReport::Agreement& agreement) {
  return {{"argument", agreement.argument},
          {"elements", agreement.elements},
          {"differing", agreement.differing},
          {"largest_difference", agreement.largest_difference}};
}

MeasuredReport::Agreement agreement_from(const JsonReader& place) {
  return {place.at("argument").string(), place.at("elements").whole_number(),
          place.at("differing").whole_number(), place.at("largest_difference").number()};
}

Json to_json(const MeasuredReport::Kernel& kernel) {
  Json json{{"kernel", kernel.kernel}};
  if (!kernel.launch_file.empty()) json["launch_file"] = kernel.launch_file;
  if (kernel.global_size) json["global_size"] = *kernel.global_size;
  if (kernel.local_size) json["local_size"] = *kernel.local_size;
  json["calls"] = kernel.calls;
  json["seconds"] = seconds_json(kernel.seconds);
  if (kernel.code) json["code"] = to_json(*kernel.code);
  if (!kernel.agreement.empty()) {
    json["agreement"] = Json::array();
    for (const auto& agreement : kernel.agreement) json["agreement"].push_back(to_json(agreement));
  }
  if (!kernel.counters.empty()) json["counters"] = kernel.counters;
  return json;
}

std::optional<std::array<std::uint64_t, 3>> size_from(const JsonReader& kernel, std::string_view key) {
  const auto place = kernel.maybe(key);
  if (!place) return std::nullopt;
  const std::vector<std::uint64_t> values = whole_numbers(*place);
  if (values.size() != 3) place->fail("not three numbers", "three");
  return std::array{values[0], values[1], values[2]};
}

MeasuredReport::Kernel kernel_from(const JsonReader& place) {
  MeasuredReport::Kernel kernel;
  kernel.kernel = place.at("kernel").string();
  kernel.launch_file = optional_string(place, "launch_file").value_or("");
  kernel.global_size = size_from(place, "global_size");
  kernel.local_size = size_from(place, "local_size");
  kernel.calls = place.at("calls").whole_number();
  kernel.seconds = seconds_from(place.at("seconds"));
  if (const auto code = place.maybe("code")) kernel.code = code_from(*code);
  if (const auto list = place.maybe("agreement"))
    for (const JsonReader& agreement : list->elements())
      kernel.agreement.push_back(agreement_from(agreement));
  if (const auto counters = place.maybe("counters"))
    for (const std::string& name : counters->keys()) kernel.counters[name] = counters->at(name).number();
  return kernel;
}

}  // namespace

std::string measured_json(const MeasuredReport& measured) {
  Json json = document_head(measured_format, measured.generator, measured.command_line);
  json["backend"] = measured.backend;
  json["device"] = {{"name", measured.device.name}};
  if (!measured.device.architecture.empty()) json["device"]["architecture"] = measured.device.architecture;
  json["device"]["driver"] = measured.device.driver;
  if (measured.scene) json["scene"] = *measured.scene;
  if (measured.variant) json["variant"] = *measured.variant;
  add_modelled_parts(json, measured.model);
  if (measured.particles) json["particles"] = *measured.particles;
  if (measured.seed) json["seed"] = *measured.seed;
  if (measured.step)
    json["step"] = {{"steps", measured.step->steps}, {"seconds", seconds_json(measured.step->seconds)}};
  json["kernels"] = Json::array();
  for (const MeasuredReport::Kernel& kernel : measured.kernels) json["kernels"].push_back(to_json(kernel));
  return json_text(json, "measured");
}

MeasuredReport read_measured(const std::filesystem::path& file) {
  const JsonReader root = read_document(file, measured_format);
  MeasuredReport measured;
  measured.generator = generator_from(root);
  measured.command_line = root.at("command_line").string();
  measured.backend = root.at("backend").string();
  const JsonReader device = root.at("device");
  measured.device = {device.at("name").string(), optional_string(device, "architecture").value_or(""),
                     device.at("driver").string()};
  measured.scene = optional_string(root, "scene");
  measured.variant = optional_string(root, "variant");
  measured.model = modelled_parts_from(root);
  measured.particles = optional_whole_number(root, "particles");
  measured.seed = optional_whole_number(root, "seed");
  if (const auto step = root.maybe("step"))
    measured.step = {step->at("steps").whole_number(), seconds_from(step->at("seconds"))};
  for (const JsonReader& kernel : root.at("kernels").elements())
    measured.kernels.push_back(kernel_from(kernel));
  return measured;
}

}  // namespace warpgrain::reports
