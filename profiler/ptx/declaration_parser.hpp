#pragma once
// Declarations of variables and parameters, which modules, signatures and bodies share.

#include <vector>

#include "profiler/ptx/module.hpp"
#include "profiler/ptx/token_cursor.hpp"

namespace warpgrain::profiler::ptx {

// `.align 4 .b8 name[16] = {...}, other;` behind its state space, the semicolon included.
std::vector<Variable> parse_variables(TokenCursor& cursor, StateSpace space);

// `(.param .u64 .ptr .global .align 4 name, ...)`, the parentheses included.
std::vector<Variable> parse_parameters(TokenCursor& cursor);

}  // namespace warpgrain::profiler::ptx
