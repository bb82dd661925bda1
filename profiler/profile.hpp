#pragma once
// Runs a launch in the simulator and counts it.

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/counters.hpp"
#include "profiler/executable.hpp"
#include "profiler/merge_policy.hpp"
#include "profiler/observers/warp_observer.hpp"
#include "profiler/timeline.hpp"
#include "profiler/what_if.hpp"

namespace warpgrain::profiler {

// Which instructions count.
struct WeightOptions {
  enum class Kind : std::uint8_t {
    ptx,
    sass,      // as ptxas makes them; an error where it is not there, or the kernel cannot be assembled
    automatic  // of SASS where that goes, else of PTX, and the counters say why
  };
  Kind kind = Kind::ptx;
  std::string arch = "sm_90";
};

struct ProfileOptions {
  WeightOptions weights = {};
  MergePolicy policy = MergePolicy::loop_postdom;
  std::uint32_t warp_width = 32;  // 4 to 64, a power of two
  bool addresses = true;          // record addresses: sectors and lines
  bool footprint = false;         // with addresses: also count the distinct sectors that are touched
  unsigned threads = 0;           // worker threads, 0 = all cores
  // Whether those who compile the kernel for the profile make it check its accesses.
  Checks checks = Checks::on;
  std::uint64_t max_instructions = RunLimits{}.max_instructions;  // of a work-item
  // Called now and then from one thread.
  std::function<void(double fraction)> progress = {};
  // Takes what the kernel prints, in order of the work-groups; null: nobody reads it.
  std::ostream* printed = nullptr;
  // What the compiler calls `source`, so that lines of other files get no labels from it.
  std::string source_name = {};
  // Questions that the traces answer beside; `trace_memory` bytes may hold traces where threads are
  // reordered.
  std::vector<WhatIf> what_if = {};
  std::uint64_t trace_memory = std::uint64_t{1} << 30;
  // Leaves out questions that sort by a count which the kernel has not; else they are errors.
  bool skip_unknown_keys = false;
  // Warps that are followed block by block.
  TimelineOptions timelines = {};
  // Sees every event, in order; then one thread runs, and slower.
  WarpObserver* observer = nullptr;
};

// Provenance and counters of one launch: what a report holds for it.
struct LaunchProfile {
  LaunchCounters counters;
  std::string source;  // the text that was compiled
  std::string source_name;
  std::string ptx;  // the PTX that was run
  std::string compiler, compile_command;
  double compile_seconds = 0, run_seconds = 0;
};

// Runs every work-group of the launch (the buffers end up as the kernel leaves them) and merges its lanes
// warp by warp; traces are dropped as soon as they are counted. `source` serves the branch labels; it may be
// empty. What is wrong with the kernel comes with the counters as diagnostics, of memory only where the
// executable checks. The counters do not depend on `threads`. Work-groups run one after another or side by
// side, so kernels that need one group to wait for another are not carried.
LaunchCounters profile_launch(const Executable& executable, const LaunchShape& shape,
                              std::span<const KernelArgument> arguments, std::string_view source,
                              const ProfileOptions& options = {});

}  // namespace warpgrain::profiler
