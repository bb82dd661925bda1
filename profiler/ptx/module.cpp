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
  const Function* declaration = nullptr;
  for (const Function& f : functions) {
    if (f.is_entry || f.name != name) continue;
    if (f.has_body) return &f;
    declaration = &f;
  }
  return declaration;
}

const Variable* Module::find_variable(std::string_view name) const {
  const auto found =
      std::find_if(variables.begin(), variables.end(), [&](const Variable& v) { return v.name == name; });
  return found == variables.end() ? nullptr : &*found;
}

}  // namespace warpgrain::profiler::ptx
