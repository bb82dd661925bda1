#pragma once
// Where the names of a module lie: an address in Memory for what all lanes share, an offset in a lane's local
// memory for the rest.

#include <string>
#include <unordered_map>

#include "tests/profiler/oracle/program.hpp"

namespace warpgrain::oracle {

// Names as one copy of a function sees them.
using Names = std::unordered_map<std::string, Source>;

// Lays out the module's variables, the kernel's parameters and shared memory.
Names lay_out_module(const ptx::Module& module, const ptx::Function& kernel, Program& program);

// Adds the registers and variables of one copy of `function`.
void lay_out_function(const ptx::Function& function, Program& program, Names& names);

}  // namespace warpgrain::oracle
