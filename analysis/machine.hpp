#pragma once
// A SIMT machine in numbers, format "warpgrain.machine/1". Every number says where it was published; those
// that ship stand in profiler/machines/, and docs/schemas/machine-1.schema.json is the JSON Schema.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/cost_constants.hpp"

namespace warpgrain {

class JsonReader;

struct Machine {
  std::string name;
  std::string description;
  std::string arch;         // what NVIDIA's compilers call it, "sm_90"; empty: none is known
  MachineValue warp_width;  // threads of a warp
  MachineValue multiprocessors;
  MachineValue lanes;             // results of 32-bit arithmetic a clock, of one multiprocessor
  MachineValue sfu_lanes;         // results of the special-function units a clock, of one multiprocessor
  MachineValue issue_rate;        // warp instructions a clock that one multiprocessor issues
  MachineValue clock;             // of the multiprocessors, 1/s
  MachineValue memory_bandwidth;  // byte/s
  std::optional<CostConstants> cost;
};

// The values under their keys, in the order of the format.
struct MachineKey {
  std::string_view key;
  MachineValue Machine::*value;
  bool whole;  // whether it is a whole number
};
inline constexpr std::array<MachineKey, 7> machine_keys{
    {{"warp_width", &Machine::warp_width, true},
     {"multiprocessors", &Machine::multiprocessors, true},
     {"lanes", &Machine::lanes, true},
     {"sfu_lanes", &Machine::sfu_lanes, true},
     {"issue_rate", &Machine::issue_rate, false},
     {"clock", &Machine::clock, false},
     {"memory_bandwidth", &Machine::memory_bandwidth, false}}};

// Reads a machine file, or the named machine of that name. InputError names file and field, or the named
// machines.
Machine load_machine(std::string_view file_or_name);
Machine parse_machine(std::string_view json_text, std::string_view file);
// The object without its "format".
Machine machine_from(const JsonReader& place);

// Those that ship, sorted by name.
std::vector<Machine> named_machines();

}  // namespace warpgrain
