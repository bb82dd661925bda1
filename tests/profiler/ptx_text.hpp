#pragma once
// PTX modules for tests: what comes before a kernel in every one.

#include <string>
#include <string_view>

namespace warpgrain::profiler {

inline std::string ptx_module(std::string_view rest) {
  return ".version 7.5\n.target sm_70\n.address_size 64\n" + std::string(rest);
}

}  // namespace warpgrain::profiler
