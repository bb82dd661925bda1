#pragma once
// What translated code knows of the lane it runs: the layout is part of the code that the translator emits.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "profiler/rendezvous.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

enum class LaneStatus : std::uint32_t {
  done,
  trace_exhausted,   // the lane was stopped at a loop: its trace is full
  budget_exhausted,  // the same: it has run as many instructions as it may
  endless_loop,      // the lane entered a loop that no branch leaves
  trapped,           // it ran a `trap`
  no_function        // it called through a pointer to none of the functions that it may reach
};

// Where an access may go without a closer look: to `begin` plus fewer than `count` times the access's size,
// and a multiple of that.
struct SiteBounds {
  std::uint64_t begin = 0, count = 0;
};

struct LaneContext;
// Looks closer at an access of a site: notes what is wrong with it. Where the access may go: to `address`, or
// to memory that nobody looks at.
using AccessHandler = std::byte* (*)(LaneContext*, std::uint32_t site, std::uint64_t address);

struct LaneContext {
  BlockIndex* trace = nullptr;              // where the next block goes
  const BlockIndex* trace_limit = nullptr;  // loops stop the lane from here on
  std::uint64_t* addresses = nullptr;
  const std::uint64_t* addresses_limit = nullptr;
  const std::byte* parameters = nullptr;  // as the kernel's signature lays them out
  std::byte* shared = nullptr;            // the work-group's, in the lowest 4 GiB
  std::byte* local = nullptr;             // the lane's own
  std::int64_t budget = 0;                // instructions that it may run
  const SiteBounds* bounds = nullptr;     // [sites]; null in unchecked code
  AccessHandler look_closer = nullptr;
  // Bytes that may be read from an address on; null in unchecked code.
  std::uint64_t (*readable)(const LaneContext*, std::uint64_t address) = nullptr;
  void* checker = nullptr;                // for look_closer and readable
  alignas(16) std::byte stored[32] = {};  // what a store is about to write, for look_closer
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
  std::uint32_t global_size[3] = {};  // in OpenCL's sense; the last groups may be smaller
  std::uint32_t linear_tid = 0;
  std::uint32_t work_group_size = 0;
  std::uint32_t shared_bytes = 0;
  std::uint64_t clock = 0;  // cycles that the lane believes to have run
};

// Where opencl_prelude.cl reads global_size.
inline constexpr std::array<std::string_view, 3> global_size_registers{"%envreg29", "%envreg30", "%envreg31"};

using LaneFunction = void (*)(LaneContext*);

}  // namespace warpgrain::profiler
