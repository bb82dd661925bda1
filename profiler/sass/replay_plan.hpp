#pragma once
// How a lane's trace tells its way through the machine code: the guards, and what leads from one to the next.

#include <cstdint>
#include <vector>

#include "profiler/sass/code_graph.hpp"
#include "profiler/sass/guard_links.hpp"
#include "profiler/sass/memory_sites.hpp"
#include "profiler/sass/ptx_decisions.hpp"
#include "profiler/sass/trip_loops.hpp"

namespace warpgrain::profiler::sass {

enum class Rule : std::uint8_t {
  decision,   // what the next decision of that number in the trace was
  trips,      // how many trips of an unrolled loop are left
  fast_path,  // the routine for rare operands is not called
  path,       // whether it is, of a division whose path the trace holds
  routine,    // a guard in the routine of such a division
  together,   // the warp's lanes have not parted
  indirect,   // which way of the table the trace goes next
  unknown,    // cannot be derived: lanes do not take it, and are counted
  call,
  ret,
  end
};

// What happens to an unrolled loop on the way from one node to the next, in order.
struct TripEvent {
  std::uint32_t loop = 0;    // index into ReplayPlan::loops
  std::uint32_t copies = 0;  // trips made; 0: the lane comes to the loop
  bool predicated = false;   // only if so many are left
};

struct Way {
  std::uint32_t node = no_code;
  std::vector<TripEvent> events;
};

// A side of a guard that asks for trips.
struct TripSide {
  std::uint32_t copies = 0;  // trips that are made before the next such guard
  std::uint32_t maybe = 0;   // and those under a predicate
  std::uint32_t most = 0;    // the most that any guard behind it can lead to at once
  std::uint32_t unit = 0;    // of what these are all multiples
  bool leaves = false;       // no such guard comes any more
};

struct Node {
  Rule rule = Rule::end;
  std::uint32_t block = 0;  // of the code
  std::uint32_t decision = no_decision;
  std::uint32_t taken_way = 0;
  bool takes_fast_path = false;
  std::uint32_t line = 0;             // of the PTX, of a path
  std::size_t guard = 0;              // of a routine: which of its guards
  std::uint32_t cause = no_decision;  // that lanes are lost to which this node parts
  std::uint32_t loop = 0;             // of trips
  TripSide taken_side, next_side;
  Way taken, next;                      // of a call: to the routine, and back
  std::vector<Way> table;               // of an indirect branch, [CodeBlock::table]
  std::vector<std::uint32_t> table_of;  // of an indirect branch, [blocks of the PTX]: entry of the table that
                                        // a run from there speaks for, or no_code
};

struct ReplayPlan {
  std::vector<Node> nodes;
  std::vector<TripLoop> loops;
  MemorySites memory;
  Way entry;
  std::vector<std::uint32_t> node_of;  // [blocks of the code], no_code for those that only go on
};

ReplayPlan make_plan(const CodeGraph& code, const PtxDecisions& decisions);

}  // namespace warpgrain::profiler::sass
