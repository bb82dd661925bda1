#include "profiler/kernel_graph.hpp"

#include <array>

namespace warpgrain::profiler {

std::string_view instruction_class_name(InstructionClass c) {
  static constexpr std::array<std::string_view, n_instruction_classes> names{
      "fp32",        "fp64",         "fp16",          "integer",        "special_function",
      "conversion",  "predicate",    "move",          "parameter_load", "constant_load",
      "global_load", "global_store", "shared_load",   "shared_store",   "local_load",
      "local_store", "generic_load", "generic_store", "atomic",         "branch",
      "barrier",     "warp_level",   "fence",         "exit",           "other"};
  return names.at(static_cast<std::size_t>(c));
}

}  // namespace warpgrain::profiler
