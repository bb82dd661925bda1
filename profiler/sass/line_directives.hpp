#pragma once
// PTX as it is assembled here: without the debug information that it came with, or with lines of our own, so
// that machine code can be followed back to its instructions.

#include <string>
#include <string_view>

namespace warpgrain::profiler::sass {

struct AssemblerText {
  std::string plain;       // no debug information
  std::string with_lines;  // a `.loc` before every instruction gives its line in the PTX
};

// Labels of debug information go, too: clang puts some into the middle of calls, where ptxas does not take
// them. Throws InputError for what is no PTX.
AssemblerText assembler_text(std::string_view ptx);

}  // namespace warpgrain::profiler::sass
