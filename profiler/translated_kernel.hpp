#pragma once
// What translation leaves for running: native code, and the facts that launches are checked against.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "profiler/access_site.hpp"
#include "profiler/diagnostic.hpp"
#include "profiler/executable.hpp"
#include "profiler/lane_context.hpp"

namespace warpgrain::profiler {

struct TranslatedKernel {
  std::string where;  // of the PTX
  KernelGraph graph;
  TraceMode mode = TraceMode::none;
  Checks checks = Checks::off;
  LaneFunction lane = nullptr;
  // Shared memory whose size the launch gives is the last one, of no bytes.
  std::vector<KernelParameter> parameters;
  std::vector<std::uint32_t> parameter_offsets;  // [parameters]
  std::uint32_t parameter_bytes = 0;
  bool is_opencl = false;             // whose rules for barriers hold
  bool takes_smaller_groups = false;  // as the last of a dimension; see smaller_groups_mark
  std::uint32_t local_bytes = 0;      // .local memory of a lane
  std::uint32_t frame_bytes = 0;      // at most what the native code keeps on its stack
  MemoryFacts memory;                 // empty: unchecked
  std::vector<std::byte*> variables;  // of the module, in order of MemoryObject::offset; null: not used
  std::vector<LoopFacts> loops;
  std::optional<std::array<std::uint32_t, 3>> required_local_size;

  bool has_dynamic_shared() const { return !parameters.empty() && parameters.back().bytes == 0; }
  // "where: kernel 'name'"
  std::string place() const;
  DiagnosticPlace source_of(std::uint32_t ptx_line) const;
  std::vector<std::pair<std::uint32_t, SourceLocation>> statement_lines;  // PTX line -> source
};

}  // namespace warpgrain::profiler
