#include "profiler/sass/launch_replay.hpp"

#include <fmt/format.h>
#include <string_view>

#include "core/error.hpp"
#include "profiler/sass/replay_check.hpp"
#include "profiler/sass/replay_totals.hpp"

namespace warpgrain::profiler::sass {
namespace {

// What keeps a launch from being replayed whatever ptxas says; empty: nothing.
std::string_view obstacle(const Executable& executable, const ProfileOptions& options) {
  if (options.warp_width != replayed_warp_width) return "the machine's warps have 32 lanes";
  if (options.policy != MergePolicy::loop_postdom) return "the policy is another than the machine's";
  if (options.observer != nullptr) return "an observer sees blocks of the PTX";
  if (executable.ptx().empty()) return "there is no PTX text";
  return {};
}

}  // namespace

LaunchReplay::LaunchReplay(const Executable& executable, const ProfileOptions& options) {
  if (options.weights.kind == WeightOptions::Kind::ptx) return;
  used_.asked = true;
  try {
    prepare(executable, options);
  } catch (const InputError& error) {
    if (options.weights.kind == WeightOptions::Kind::sass) throw;
    used_.reason = error.what();
    kernel_.reset();
  }
}

void LaunchReplay::prepare(const Executable& executable, const ProfileOptions& options) {
  architecture_number(options.weights.arch);
  const std::string_view in_the_way = obstacle(executable, options);
  if (!in_the_way.empty()) throw InputError(std::string(in_the_way));
  const std::optional<Ptxas> ptxas = find_ptxas();
  if (!ptxas)
    throw InputError("ptxas is not installed: not in PATH, nor below CUDA_HOME, CUDA_PATH or /usr/local/cuda");
  used_.arch = options.weights.arch;
  used_.ptxas = ptxas->version;
  kernel_ = assemble_kernel(*ptxas, executable.ptx(), executable.graph(), options.weights.arch);
}

WarpReplayer* LaunchReplay::new_replayer() {
  if (!kernel_) return nullptr;
  Thread& thread = threads_.emplace_back(
      Thread{ReplayCounters(kernel_->code, kernel_->plan, kernel_->decisions.graph()), nullptr});
  thread.replayer = make_warp_replayer(kernel_->code, kernel_->plan, kernel_->decisions, thread.counters);
  return thread.replayer.get();
}

void LaunchReplay::finish(const SourceLines& source, const WarpCounters& of_ptx, LaunchCounters& launch) {
  if (kernel_ && !threads_.empty()) {
    ReplayCounters& sum = threads_.front().counters;
    for (std::size_t k = 1; k < threads_.size(); ++k) sum.add(threads_[k].counters);
    used_.underived = sum.unresolved();
    used_.fast_paths = sum.fast_paths;
    const std::vector<std::string> found = contradictions(*kernel_, sum, of_ptx);
    if (used_.underived != 0) {
      used_.reason = fmt::format("{} choices of lanes cannot be derived from their traces", used_.underived);
    } else if (!found.empty()) {
      used_.reason = fmt::format("the replay contradicts the trace: {}", found.front());
    } else {
      used_.sass = true;
      put_replay(*kernel_, sum, source, launch);
    }
  }
  launch.weights = used_;
}

}  // namespace warpgrain::profiler::sass
