#pragma once
// The line table of a cubin: DWARF 2, section 6.2, "Line Number Information". One file, line and address are
// all that matters here.

#include <cstdint>
#include <string_view>
#include <vector>

#include "profiler/sass/cubin.hpp"

namespace warpgrain::profiler::sass {

struct LineSequence {
  std::uint64_t address_at = 0;  // place in the section of the address that it begins with, to be relocated
  std::vector<LineRow> rows;     // without the end of the sequence
};

// Throws InputError for a broken section.
std::vector<LineSequence> read_line_program(std::string_view section);

}  // namespace warpgrain::profiler::sass
