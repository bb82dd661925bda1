#pragma once
// What translated code knows of the lane it runs: the layout is part of the code that the translator emits.

#include <cstddef>
#include <cstdint>
#include <string>

#include "profiler/rendezvous.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

enum class LaneStatus : std::uint32_t {
  done,
  trace_exhausted,  // the lane was stopped at a loop: its trace is full
  endless_loop,     // the lane entered a loop that no branch leaves
  trapped,          // it ran a `trap`
  no_function       // it called through a pointer to none of the functions that it may reach
};

struct LaneContext {
  BlockIndex* trace = nullptr;              // where the next block goes
  const BlockIndex* trace_limit = nullptr;  // loops stop the lane from here on
  std::uint64_t* addresses = nullptr;
  const std::uint64_t* addresses_limit = nullptr;
  const std::byte* parameters = nullptr;  // as the kernel's signature lays them out
  std::byte* shared = nullptr;            // the work-group's, in the lowest 4 GiB
  // Waits, at `line` of the PTX, for the answer to `rendezvous`.
  void (*wait)(LaneContext*, std::uint32_t line) = nullptr;
  std::string* printed = nullptr;  // what printf appends to
  void* fiber = nullptr;           // what the lane runs on, for `wait`
  Rendezvous rendezvous;
  LaneStatus status = LaneStatus::done;
  std::uint32_t line = 0;  // of the PTX, where a status other than done arose or the lane waits
  std::uint32_t tid[3] = {};
  std::uint32_t ntid[3] = {};
  std::uint32_t ctaid[3] = {};
  std::uint32_t nctaid[3] = {};
  std::uint32_t linear_tid = 0;
  std::uint32_t work_group_size = 0;
  std::uint32_t shared_bytes = 0;
  std::uint64_t clock = 0;  // cycles that the lane believes to have run
};

using LaneFunction = void (*)(LaneContext*);

}  // namespace warpgrain::profiler
