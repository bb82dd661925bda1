#include "profiler/ptx/memory_layout.hpp"

#include <fmt/format.h>
#include <set>

#include "core/error.hpp"
#include "profiler/launch_check.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {
namespace {

// More than any device has; keeps 32-bit offsets from wrapping.
constexpr std::uint64_t max_bytes = std::uint64_t{1} << 24;
// CUDA C++ Programming Guide, "Technical Specifications per Compute Capability": local memory per thread.
constexpr std::uint64_t max_local_bytes = std::uint64_t{512} << 10;

std::uint32_t append(const Variable& variable, std::uint32_t& end, std::string_view where) {
  const std::uint64_t offset =
      (std::uint64_t{end} + variable.alignment - 1) / variable.alignment * variable.alignment;
  if (offset + variable.bytes > max_bytes)
    throw_input_error(place(where, variable.line),
                      fmt::format("'{}' of {} bytes", variable.name, variable.bytes),
                      fmt::format("at most {} bytes together", max_bytes));
  end = static_cast<std::uint32_t>(offset + variable.bytes);
  return static_cast<std::uint32_t>(offset);
}

void collect_names(const Operand& operand, std::set<std::string_view>& names) {
  if (!operand.name.empty()) names.insert(operand.name);
  for (const Operand& element : operand.elements) collect_names(element, names);
}

}  // namespace

MemoryLayout lay_out(const Module& module, const Function& kernel, std::string_view where) {
  MemoryLayout layout;
  for (const Variable& parameter : kernel.parameters)
    layout.parameter_offsets[parameter.name] = append(parameter, layout.parameter_bytes, where);
  const auto add_shared = [&](const Variable& variable) {
    if (variable.space == StateSpace::shared && !variable.external)
      layout.shared_offsets[variable.name] = append(variable, layout.shared_bytes, where);
  };
  for (const Variable& variable : kernel.variables) {
    add_shared(variable);
    if (variable.space == StateSpace::local)
      layout.local_offsets[variable.name] = append(variable, layout.local_bytes, where);
  }
  if (layout.local_bytes > max_local_bytes)
    throw_input_error(place(where, kernel.line),
                      fmt::format("{} bytes of local memory a work-item", layout.local_bytes),
                      fmt::format("at most {}", max_local_bytes));
  std::set<std::string_view> named;
  for (const Statement& statement : kernel.statements)
    for (const Operand& operand : statement.operands) collect_names(operand, named);
  for (const Variable& variable : module.variables)
    if (named.count(variable.name)) add_shared(variable);
  for (const Variable& variable : module.variables) {
    if (!named.count(variable.name) || variable.space != StateSpace::shared || !variable.external) continue;
    layout.dynamic_shared = &variable;
    layout.shared_offsets[variable.name] = dynamic_shared_offset(layout.shared_bytes);
  }
  return layout;
}

}  // namespace warpgrain::profiler::ptx
