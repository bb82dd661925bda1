#pragma once
// Calls of device functions, put in place: each call gets its own copy of the function's blocks, so that a
// kernel is one flat graph. A lane's way through a shared function and through its copies is the same.

#include <string_view>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

// `entry` without calls of functions. The `call` stays as an instruction without effect; the `ret` of a copy
// becomes a branch behind it. A call through a pointer keeps its operands and is a branch to the copies of
// the functions that it may reach: the pointer, then a label and the function's address each. Throws
// InputError for recursion, functions without a body and pointers that no function fits.
Function inline_calls(const Module& module, const Function& entry, std::string_view where);

}  // namespace warpgrain::profiler::ptx
