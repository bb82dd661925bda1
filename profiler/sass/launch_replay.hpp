#pragma once
// The replay of one launch: decides whether there is one, gives each thread of the program its replayer, and
// puts the result into the launch's counters.

#include <deque>
#include <memory>
#include <optional>

#include "profiler/counters.hpp"
#include "profiler/executable.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/profile.hpp"
#include "profiler/sass/machine_kernel.hpp"
#include "profiler/sass/warp_replayer.hpp"
#include "profiler/source_lines.hpp"

namespace warpgrain::profiler::sass {

class LaunchReplay {
 public:
  // Throws InputError where SASS is insisted on and cannot be had. The executable outlives it.
  LaunchReplay(const Executable& executable, const ProfileOptions& options);

  // Null where PTX counts. Not to be called side by side; belongs to the replay.
  WarpReplayer* new_replayer();

  // When every warp has been replayed and, into `of_ptx`, merged.
  void finish(const SourceLines& source, const WarpCounters& of_ptx, LaunchCounters& launch);

 private:
  struct Thread {
    ReplayCounters counters;
    std::unique_ptr<WarpReplayer> replayer;
  };
  void prepare(const Executable& executable, const ProfileOptions& options);

  WeightsUsed used_;
  std::unique_ptr<MachineKernel> kernel_;
  std::deque<Thread> threads_;  // whose counters keep their place
};

}  // namespace warpgrain::profiler::sass
