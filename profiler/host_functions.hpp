#pragma once
// C++ functions that translated code calls by name.

#include <span>
#include <string_view>

namespace warpgrain::profiler {

struct HostFunction {
  std::string_view name;
  void* address;
};

std::span<const HostFunction> host_functions();

}  // namespace warpgrain::profiler
