#pragma once
// A kernel as the interpreter runs it: its instructions in one row, each call followed by a copy of the
// function it calls, every name resolved, every instruction decoded once.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "profiler/ptx/module.hpp"
#include "tests/profiler/oracle/operation.hpp"

namespace warpgrain::oracle {

// Index of a step; Program::steps.size() is where lanes end.
using Place = std::uint32_t;

// What an operand stands for.
struct Source {
  enum class Kind : std::uint8_t { nothing, reg, bits, float32, float64, special, address, lane_address };
  Kind kind = Kind::nothing;
  bool negated = false;     // of a predicate
  ptx::ScalarType type;     // of a register
  std::uint32_t index = 0;  // of a register
  std::uint64_t value = 0;  // bits; an address; what is added to a register
  std::string special;      // %tid.x, ...
};

struct Step {
  enum class Kind : std::uint8_t { compute, pack, unpack, load, store, atomic, barrier, jump, trap, nothing };
  Kind kind = Kind::nothing;
  const ptx::Statement* statement = nullptr;
  std::optional<Source> guard;
  std::vector<Source> outputs;  // registers, or nothing
  std::vector<Source> inputs;
  Operation operation;      // of compute and atomic
  ptx::ScalarType element;  // of pack, unpack, load, store
  Source address;           // of load, store, atomic
  bool counts_access =
      false;  // whether a device's counters see the access: not parameters, constants, .local
  // Where lanes go from here. Of a conditional branch or end: first where those go that take it, last where
  // the others do. Of a branch by table: its entries, each once.
  std::vector<Place> to;
  std::vector<Place> table;  // of a branch by table, by index
};

struct Program {
  std::vector<Step> steps;
  std::uint32_t n_registers = 0;
  std::uint32_t local_bytes = 0;  // of a lane
  std::uint32_t shared_bytes = 0;
  std::uint32_t parameter_bytes = 0;
  std::vector<std::uint32_t> parameter_offsets;
  std::vector<std::byte> variables;  // of the module, as they are at the start
};

// Throws UnknownInstruction for what the interpreter does not know. The program points into `module`.
Program decode(const ptx::Module& module, const ptx::Function& kernel);

}  // namespace warpgrain::oracle
