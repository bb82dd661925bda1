#pragma once
// C++ functions that translated code calls by name.

#include <string>
#include <utility>
#include <vector>

namespace warpgrain::profiler {

struct HostFunction {
  std::string name;
  void* address;
};

template <class Function>
HostFunction host_function(std::string name, Function* function) {
  return {std::move(name), reinterpret_cast<void*>(function)};
}

std::vector<HostFunction> host_functions();

}  // namespace warpgrain::profiler
