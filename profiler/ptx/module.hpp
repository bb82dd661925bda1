#pragma once
// A PTX module as plain structs: what the parser makes and the translator reads.

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/ptx/types.hpp"

namespace warpgrain::profiler::ptx {

// Names of registers and local variables are unique in their function: the parser renames what an inner `{ }`
// hides.
struct Operand {
  enum class Kind : std::uint8_t {
    name,     // register, special register ("%tid.x"), symbol (with `value` as offset), label, `_`
    integer,  // `value`
    float32,  // `value` holds the bits
    float64,  // `value` holds the bits
    address,  // [name + value]; an absolute address has no name
    vector,   // {elements}
    pair,     // p|q
    list      // (elements), of a call
  };
  Kind kind = Kind::name;
  std::string name;
  bool negated = false;     // !p
  std::uint64_t value = 0;  // offsets in two's complement
  std::vector<Operand> elements;
};

struct Guard {
  std::string predicate;
  bool negated = false;
};

struct Statement {
  std::uint32_t line = 0;  // in the PTX, from 1
  std::optional<Guard> guard;
  std::string opcode;                  // before the first dot
  std::vector<std::string> modifiers;  // behind it
  std::vector<Operand> operands;
  SourceLocation location;
  std::string text;
};

// A place in an initialiser that takes the address of a symbol, 8 bytes.
struct Relocation {
  std::uint64_t offset = 0;  // in the variable's bytes
  std::string symbol;
  std::uint64_t addend = 0;
};

struct Variable {
  std::uint32_t line = 0;
  StateSpace space = StateSpace::global;
  std::string name;
  ScalarType type;
  std::uint32_t alignment = 1;
  std::uint64_t bytes = 0;
  bool external = false;                                              // .extern: declared, not defined
  KernelParameter::Pointer pointer = KernelParameter::Pointer::none;  // of a kernel's parameter
  std::vector<std::uint8_t> initial;                                  // empty: zeros
  std::vector<Relocation> relocations;
};

struct Function {
  std::uint32_t line = 0;
  std::string name;
  bool is_entry = false;
  bool has_body = false;
  std::vector<Variable> results;  // of a .func
  std::vector<Variable> parameters;
  std::vector<std::pair<std::string, ScalarType>> registers;
  std::vector<Variable> variables;  // local, shared, and the .param of calls
  std::vector<Statement> statements;
  std::unordered_map<std::string, std::size_t> labels;  // index of the statement behind it
  std::unordered_map<std::string, std::vector<std::string>> branch_tables;  // .branchtargets
  std::unordered_map<std::string, std::vector<std::string>> call_targets;   // .calltargets
  std::optional<std::array<std::uint32_t, 3>> required_local_size;          // .reqntid
};

struct Module {
  std::map<std::uint32_t, std::string> files;               // .file
  std::map<std::string, std::string, std::less<>> aliases;  // .alias: name -> function
  // `.target ..., texmode_independent`: how OpenCL's drivers want it, and CUDA's never do.
  bool is_opencl = false;
  std::vector<Variable> variables;
  std::vector<Function> functions;

  const Function* find_entry(std::string_view name) const;
  const Function* find_function(std::string_view name) const;  // a .func with a body, else its declaration
  const Variable* find_variable(std::string_view name) const;
  // What a pointer to a device function holds; nothing when there is none of that name with a body.
  std::optional<std::uint64_t> function_address(std::string_view name) const;
};

}  // namespace warpgrain::profiler::ptx
