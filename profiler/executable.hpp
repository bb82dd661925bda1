#pragma once
// A kernel translated from PTX to native, traced code. The only header through which LLVM's work is used; it
// names nothing of LLVM.

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/kernel_graph.hpp"
#include "profiler/launch.hpp"
#include "profiler/trace.hpp"

namespace warpgrain::profiler {

enum class TraceMode : std::uint8_t {
  none,    // plain native run: the base line of every cost figure
  blocks,  // block traces
  blocks_and_addresses
};

enum class Checks : std::uint8_t {
  off,
  on  // of every access to memory: bounds, alignment, rights, initialisation, races
};

// How far a launch may go.
struct RunLimits {
  // A work-item that has run about so many is stopped; loops count as a whole a pass.
  std::uint64_t max_instructions = 100'000'000;
  // After so many stopped work-items the launch is given up: each takes as long as its limits allow.
  std::uint32_t max_stopped = 16;
  // Whether several threads run its work-groups side by side.
  bool concurrent = false;
};

class LaunchMonitor;

// Runs work-groups of one launch on the calling thread and holds their traces. One a thread; reused from
// group to group.
class WorkGroupRunner {
 public:
  virtual ~WorkGroupRunner() = default;
  // Runs work-group `group` to its end. The traces, [work_group_size] in order of the linear local id, stay
  // valid until the next call; those of work-items that were stopped are null.
  virtual std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) = 0;
  // What the groups since the last call printed, in the order in which their work-items ran.
  virtual std::string take_printed() = 0;
};

class Executable {
 public:
  // Translates and compiles `kernel` of the module. Throws InputError naming the kernels there are, or the
  // PTX line and instruction that is not carried. `where` names the PTX in messages.
  static std::unique_ptr<Executable> compile(std::string_view ptx, std::string_view kernel, TraceMode mode,
                                             std::string_view where, Checks checks = Checks::off);
  virtual ~Executable() = default;
  virtual const KernelGraph& graph() const = 0;
  // The module that it was made from; empty where there was no text.
  virtual std::string_view ptx() const { return {}; }
  virtual std::span<const KernelParameter> parameters() const = 0;
  // What the runners of one launch note what they find in. Checks the shape, and the arguments against the
  // parameters (InputError names the argument). Executable and arguments outlive it.
  virtual std::unique_ptr<LaunchMonitor> monitor(const LaunchShape& shape,
                                                 std::span<const KernelArgument> arguments,
                                                 const RunLimits& limits = {}) const = 0;
  // Each thread takes a runner of its own; the monitor outlives them.
  virtual std::unique_ptr<WorkGroupRunner> runner(LaunchMonitor& monitor) const = 0;
  // A runner with a monitor of its own, which refuses what it finds: run() throws InputError with the first
  // diagnostic.
  std::unique_ptr<WorkGroupRunner> runner(const LaunchShape& shape,
                                          std::span<const KernelArgument> arguments) const;
};

// Names of the kernels (.entry) in a PTX module, in order.
std::vector<std::string> kernels_in(std::string_view ptx);

}  // namespace warpgrain::profiler
