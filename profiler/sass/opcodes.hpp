#pragma once
// Operations by their number.

#include <cstdint>
#include <string_view>

#include "profiler/kernel_graph.hpp"

namespace warpgrain::profiler::sass {

struct Operation {
  std::uint16_t number;  // bits 0 to 8 of the instruction
  std::string_view name;
  InstructionClass instruction_class;
  // Whether it is issued to the pipe for transcendental functions and conversions, ncu's xu.
  bool special_function = false;
};

// Null for numbers that are not known.
const Operation* find_operation(std::uint16_t number);

}  // namespace warpgrain::profiler::sass
