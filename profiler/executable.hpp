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

// Runs work-groups of one launch on the calling thread and holds their traces. One a thread; reused from
// group to group.
class WorkGroupRunner {
 public:
  virtual ~WorkGroupRunner() = default;
  // Runs work-group `group` to its end. The traces, [work_group_size] in order of the linear local id, stay
  // valid until the next call. Throws InputError for barrier divergence and for an exhausted trace.
  virtual std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) = 0;
  // What the groups since the last call printed, in the order in which their work-items ran.
  virtual std::string take_printed() = 0;
};

class Executable {
 public:
  // Translates and compiles `kernel` of the module. Throws InputError naming the kernels there are, or the
  // PTX line and instruction that is not carried. `where` names the PTX in messages.
  static std::unique_ptr<Executable> compile(std::string_view ptx, std::string_view kernel, TraceMode mode,
                                             std::string_view where);
  virtual ~Executable() = default;
  virtual const KernelGraph& graph() const = 0;
  virtual std::span<const KernelParameter> parameters() const = 0;
  // Checks the shape, and the arguments against the parameters (InputError names the argument). Executable
  // and arguments outlive the runner; each thread takes a runner of its own.
  virtual std::unique_ptr<WorkGroupRunner> runner(const LaunchShape& shape,
                                                  std::span<const KernelArgument> arguments) const = 0;
};

// Names of the kernels (.entry) in a PTX module, in order.
std::vector<std::string> kernels_in(std::string_view ptx);

}  // namespace warpgrain::profiler
