#include "analysis/machine.hpp"

#include <bit>
#include <filesystem>
#include <fmt/format.h>
#include <regex>

#include "analysis/embedded_machines.hpp"
#include "core/error.hpp"
#include "core/file_io.hpp"
#include "core/json_reader.hpp"

namespace warpgrain {
namespace {

constexpr std::string_view machine_format = "warpgrain.machine/1";
constexpr std::uintmax_t file_size_limit = std::uintmax_t{1} << 20;  // bytes
constexpr std::string_view extension = ".json";

MachineValue value_from(const JsonReader& place, bool whole) {
  place.require_keys({"value", "source"});
  MachineValue value;
  value.value = whole ? static_cast<double>(place.at("value").count()) : place.at("value").number_above(0);
  value.source = place.at("source").string();
  if (value.source.empty()) place.at("source").fail("nothing", "the document that the value is from");
  return value;
}

CostConstants cost_from(const JsonReader& place) {
  std::vector<std::string_view> keys;
  for (const CostKey& key : cost_keys) keys.push_back(key.key);
  place.require_keys(keys);
  CostConstants cost;
  for (const CostKey& key : cost_keys) cost.*key.value = value_from(place.at(key.key), false);
  if (cost.overlap.value < 1)
    place.at("overlap").at("value").fail(fmt::format("{}", cost.overlap.value), "1 or more");
  return cost;
}

std::string_view name_of(const EmbeddedMachine& machine) {
  return machine.path.substr(0, machine.path.size() - extension.size());
}

std::string arch_from(const JsonReader& place) {
  std::string arch = place.string();
  if (!std::regex_match(arch, std::regex("sm_[0-9]+a?")))
    place.fail(fmt::format("'{}'", arch), "an architecture as NVIDIA's compilers call it: sm_90");
  return arch;
}

}  // namespace

Machine machine_from(const JsonReader& place) {
  Machine machine;
  machine.name = place.at("name").string();
  if (machine.name.empty()) place.at("name").fail("nothing", "the machine's name");
  machine.description = place.at("description").string();
  if (const auto arch = place.maybe("arch")) machine.arch = arch_from(*arch);
  for (const MachineKey& key : machine_keys) machine.*key.value = value_from(place.at(key.key), key.whole);
  if (const auto cost = place.maybe("cost")) machine.cost = cost_from(*cost);
  const auto width = static_cast<unsigned long long>(machine.warp_width.value);
  if (width < 4 || width > 64 || !std::has_single_bit(width))
    place.at("warp_width").fail(fmt::format("{}", width), "4, 8, 16, 32 or 64");
  return machine;
}

Machine parse_machine(std::string_view json_text, std::string_view file) {
  const JsonReader document = JsonReader::parse(json_text, file);
  const JsonReader format = document.at("format");
  if (format.string() != machine_format)
    format.fail(fmt::format("'{}'", format.string()), fmt::format("'{}'", machine_format));
  document.require_keys({"format", "name", "description", "arch", "warp_width", "multiprocessors", "lanes",
                         "sfu_lanes", "issue_rate", "clock", "memory_bandwidth", "cost"});
  return machine_from(document);
}

Machine load_machine(std::string_view file_or_name) {
  for (const EmbeddedMachine& machine : embedded_machines())
    if (name_of(machine) == file_or_name) return parse_machine(machine.text, machine.path);
  const std::filesystem::path file(file_or_name);
  if (!std::filesystem::exists(file)) {
    std::vector<std::string_view> names;
    for (const EmbeddedMachine& machine : embedded_machines()) names.push_back(name_of(machine));
    throw_unknown_name("--machine", "file or machine", file_or_name, names);
  }
  return parse_machine(read_text_file(file, file_size_limit), file_or_name);
}

std::vector<Machine> named_machines() {
  std::vector<Machine> machines;
  for (const EmbeddedMachine& machine : embedded_machines())
    machines.push_back(parse_machine(machine.text, machine.path));
  return machines;
}

}  // namespace warpgrain
