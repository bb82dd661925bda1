#pragma once
// The body of a .entry or .func: `{ declarations, labels and instructions }`.

#include "profiler/ptx/module.hpp"
#include "profiler/ptx/token_cursor.hpp"

namespace warpgrain::profiler::ptx {

// Fills registers, variables, statements, labels and tables of `function`, from '{' to its '}'.
void parse_body(TokenCursor& cursor, Function& function);

}  // namespace warpgrain::profiler::ptx
