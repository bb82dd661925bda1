#pragma once
// How messages name a place in PTX, which is often no file that a user wrote.

#include <string>
#include <string_view>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

// "kernel.cl, PTX line 12"
std::string place(std::string_view where, std::uint32_t line);

// "kernel.cl, PTX line 12 (law.h:30)" where a line table says what the instruction was made from.
std::string place(std::string_view where, const Module& module, const Statement& statement);

}  // namespace warpgrain::profiler::ptx
