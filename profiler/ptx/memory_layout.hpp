#pragma once
// Where a kernel's parameters, its static shared memory and a lane's local memory lie.

#include <cstdint>
#include <string>
#include <unordered_map>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

struct MemoryLayout {
  std::unordered_map<std::string, std::uint32_t> parameter_offsets;
  std::uint32_t parameter_bytes = 0;
  std::unordered_map<std::string, std::uint32_t>
      shared_offsets;  // in the work-group's block of shared memory
  std::uint32_t shared_bytes = 0;
  // Shared memory whose size the launch gives (.extern .shared) lies behind the static one, all variables at
  // one place.
  const Variable* dynamic_shared = nullptr;
  std::unordered_map<std::string, std::uint32_t> local_offsets;  // in a lane's local memory
  std::uint32_t local_bytes = 0;
};

// `kernel` is an entry without calls. Of the module's shared variables only those that it names count.
MemoryLayout lay_out(const Module& module, const Function& kernel, std::string_view where);

}  // namespace warpgrain::profiler::ptx
