#include "profiler/sass/launch_replay.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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

// What the traces did not tell, most first.
std::string gaps(const MachineKernel& kernel, const ReplayCounters& counters) {
  std::vector<std::pair<std::uint64_t, std::string>> found;
  for (std::size_t n = 0; n < counters.underived.size(); ++n) {
    const Instruction& guard = kernel.code.last_of(kernel.code.blocks[kernel.plan.nodes[n].block]);
    if (counters.underived[n] != 0)
      found.emplace_back(counters.underived[n], fmt::format("{} at 0x{:x} (PTX line {})", mnemonic(guard),
                                                            guard.address, guard.line));
  }
  if (counters.out_of_step != 0)
    found.emplace_back(counters.out_of_step, "lanes whose trace went another way");
  if (counters.stuck != 0) found.emplace_back(counters.stuck, "meetings that some lanes did not come to");
  std::ranges::sort(found, std::greater{});
  std::vector<std::string> texts;
  for (const auto& [count, what] : found) texts.push_back(fmt::format("{} {}", count, what));
  constexpr std::size_t most = 3;
  if (texts.size() > most) texts.resize(most);
  return fmt::format("choices that the traces do not tell: {}", fmt::join(texts, ", "));
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
    throw InputError(
        "ptxas is not installed: not in PATH, nor below CUDA_HOME, CUDA_PATH or /usr/local/cuda");
  used_.arch = options.weights.arch;
  used_.ptxas = ptxas->version;
  kernel_ = assemble_kernel(*ptxas, executable.ptx(), executable.graph(), options.weights.arch);
  used_.registers = kernel_->registers;
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
    used_.turns_assumed = sum.turns_assumed;
    used_.trips_assumed = sum.trips_assumed;
    const std::vector<std::string> found = contradictions(*kernel_, sum, of_ptx);
    if (used_.underived != 0) {
      used_.reason = gaps(*kernel_, sum);
    } else if (!found.empty()) {
      used_.reason = fmt::format("the replay contradicts the trace: {}", found.front());
    } else {
      used_.sass = true;
      launch.weights = used_;
      put_replay(*kernel_, sum, of_ptx, source, launch);
      return;
    }
  }
  launch.weights = used_;
}

}  // namespace warpgrain::profiler::sass
