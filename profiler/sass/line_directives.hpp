#pragma once
// PTX whose machine code can be followed back to its lines.

#include <string>
#include <string_view>

namespace warpgrain::profiler::sass {

// The module with a `.loc` before every instruction that gives its line in `ptx`, and without the directives
// that it had. Throws InputError for what is no PTX.
std::string with_line_directives(std::string_view ptx);

}  // namespace warpgrain::profiler::sass
