#include "tests/profiler/oracle/symbols.hpp"

#include <algorithm>
#include <cstring>
#include <fmt/format.h>
#include <stdexcept>

#include "tests/profiler/oracle/memory.hpp"

namespace warpgrain::oracle {
namespace {

// Room for the variable at `end`, which moves behind it; where it begins.
std::uint32_t place(const ptx::Variable& variable, std::uint32_t& end) {
  const std::uint32_t alignment = std::max(variable.alignment, 1U);
  const std::uint32_t begin = (end + alignment - 1) / alignment * alignment;
  end = begin + static_cast<std::uint32_t>(variable.bytes);
  return begin;
}

Source address_of(Memory::Region region, std::uint32_t offset) {
  Source source;
  source.kind = Source::Kind::address;
  source.value = Memory::base_of(region) + offset;
  return source;
}

void place_shared(const ptx::Variable& variable, Program& program, Names& names) {
  if (variable.external) throw UnknownInstruction(".extern .shared");
  names[variable.name] = address_of(Memory::shared, place(variable, program.shared_bytes));
}

}  // namespace

Names lay_out_module(const ptx::Module& module, const ptx::Function& kernel, Program& program) {
  Names names;
  std::uint32_t end = 0;
  for (const ptx::Variable& variable : module.variables) {
    if (variable.space == ptx::StateSpace::shared) {
      place_shared(variable, program, names);
    } else if (!variable.external) {
      names[variable.name] = address_of(Memory::variables, place(variable, end));
    }
  }
  program.variables.resize(end);
  for (const ptx::Variable& variable : module.variables) {
    if (variable.external || variable.space == ptx::StateSpace::shared) continue;
    std::byte* const begin =
        program.variables.data() + (names.at(variable.name).value - Memory::base_of(Memory::variables));
    if (!variable.initial.empty()) std::memcpy(begin, variable.initial.data(), variable.initial.size());
    for (const ptx::Relocation& relocation : variable.relocations) {
      const std::uint64_t address = names.at(relocation.symbol).value + relocation.addend;
      std::memcpy(begin + relocation.offset, &address, sizeof address);
    }
  }
  for (const ptx::Variable& parameter : kernel.parameters) {
    program.parameter_offsets.push_back(place(parameter, program.parameter_bytes));
    names[parameter.name] = address_of(Memory::parameters, program.parameter_offsets.back());
  }
  return names;
}

void lay_out_function(const ptx::Function& function, Program& program, Names& names) {
  for (const auto& [name, type] : function.registers) {
    Source source;
    source.kind = Source::Kind::reg;
    source.type = type;
    source.index = program.n_registers++;
    names[name] = source;
  }
  for (const ptx::Variable& variable : function.variables) {
    if (variable.space == ptx::StateSpace::shared) {
      place_shared(variable, program, names);
      continue;
    }
    Source source;
    source.kind = Source::Kind::lane_address;
    source.value = place(variable, program.local_bytes);
    names[variable.name] = source;
  }
}

}  // namespace warpgrain::oracle
