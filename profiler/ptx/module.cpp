#include "profiler/ptx/module.hpp"

#include <algorithm>

namespace warpgrain::profiler::ptx {

const Function* Module::find_entry(std::string_view name) const {
  const auto found = std::find_if(functions.begin(), functions.end(), [&](const Function& f) {
    return f.is_entry && f.has_body && f.name == name;
  });
  return found == functions.end() ? nullptr : &*found;
}

const Function* Module::find_function(std::string_view name) const {
  if (const auto alias = aliases.find(name); alias != aliases.end()) name = alias->second;
  const Function* declaration = nullptr;
  for (const Function& f : functions) {
    if (f.is_entry || f.name != name) continue;
    if (f.has_body) return &f;
    declaration = &f;
  }
  return declaration;
}

std::optional<std::uint64_t> Module::function_address(std::string_view name) const {
  const Function* const function = find_function(name);
  if (!function || !function->has_body) return std::nullopt;
  // Places in a page that nobody can read, in steps as code has them.
  return 16 * static_cast<std::uint64_t>(function - functions.data() + 1);
}

const Variable* Module::find_variable(std::string_view name) const {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const Variable& v) { return v.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

}  // namespace warpgrain::profiler::ptx
