#pragma once
// Which access of the PTX each memory instruction of the machine code carries out.

#include <cstdint>
#include <vector>

#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/ptx_decisions.hpp"

namespace warpgrain::profiler::sass {

inline constexpr std::uint32_t no_stream = 0xFFFFFFFF;

// The accesses of one line of the PTX, whose addresses a lane's trace holds in the order of execution. Copies
// of an inlined function share their lines.
struct AccessStream {
  InstructionClass access = InstructionClass::global_load;
  std::uint8_t bytes = 0;   // a lane's
  bool predicated = false;  // in the PTX: then the trace says which lanes access nothing
  // Where its addresses are: those of a block of the PTX stand together, so streams of one block share a
  // queue of where they begin.
  std::uint32_t queue = 0, offset = 0;
  bool has_site = false;  // some instruction of the code has its line
  // Of one with a site: streams of the same kind that have none. The assembler may have made one instruction
  // of several.
  std::vector<std::uint32_t> without_site = {};
};

struct MemorySite {
  std::uint32_t stream = 0;
  bool guarded = false;  // runs under a predicate that the access of the PTX has not
};

struct MemorySites {
  std::vector<AccessStream> streams;
  std::vector<std::vector<MemorySite>> of_block;  // [blocks of the code], in order
  std::vector<std::vector<std::uint32_t>>
      of_access;  // [blocks of the PTX][accesses]: their stream or no_stream
  std::uint32_t n_queues = 0;
  struct QueueEntry {
    std::uint32_t queue = 0, first = 0;  // the access whose address it begins with
  };
  std::vector<std::vector<QueueEntry>> queues_of;  // [blocks of the PTX]: those that note a run of the block
};

MemorySites find_memory_sites(const CodeGraph& code, const PtxDecisions& decisions);

}  // namespace warpgrain::profiler::sass
