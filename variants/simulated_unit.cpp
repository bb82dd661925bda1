#include "variants/simulated_unit.hpp"

#ifdef WARPGRAIN_HAS_SIMULATOR

#include <algorithm>
#include <chrono>
#include <deque>

#include "profiler/approximate_ptx.hpp"

namespace warpgrain {
namespace {

// Enough for the units of a few variants side by side.
constexpr std::size_t units_kept = 12;

}  // namespace

SimulatedUnit::SimulatedUnit(const SourceUnit& source, KernelCompiler compiler, profiler::TraceMode mode,
                             profiler::Checks checks, Approximations approximations)
    : source_(source),
      compiler_(compiler),
      mode_(mode),
      checks_(checks),
      approximations_(approximations),
      compiled_(compile_unit(source, compiler)) {
  if (approximations == Approximations::as_far_off_as_allowed)
    compiled_.ptx = profiler::with_displaced_approximations(compiled_.ptx);
  if (checks == profiler::Checks::on)
    declarations_ = profiler::declaration_bitcode(source.text, name, source.build_options);
}

std::shared_ptr<SimulatedUnit> SimulatedUnit::of(const SourceUnit& source, KernelCompiler compiler,
                                                 profiler::TraceMode mode, profiler::Checks checks,
                                                 Approximations approximations) {
  static std::mutex mutex;
  static std::deque<std::shared_ptr<SimulatedUnit>> kept;  // used last first
  const auto is_it = [&](const std::shared_ptr<SimulatedUnit>& unit) {
    return unit->compiler_ == compiler && unit->mode_ == mode && unit->checks_ == checks &&
           unit->approximations_ == approximations && unit->source_.text == source.text &&
           unit->source_.build_options == source.build_options;
  };
  const auto take = [&]() -> std::shared_ptr<SimulatedUnit> {
    const std::lock_guard lock(mutex);
    const auto found = std::ranges::find_if(kept, is_it);
    if (found == kept.end()) return nullptr;
    std::rotate(kept.begin(), found, found + 1);
    return kept.front();
  };
  if (auto unit = take()) return unit;
  // Compiled outside of the lock, by two threads at once if need be.
  std::shared_ptr<SimulatedUnit> unit(new SimulatedUnit(source, compiler, mode, checks, approximations));
  const std::lock_guard lock(mutex);
  kept.push_front(unit);
  if (kept.size() > units_kept) kept.pop_back();
  return unit;
}

const SimulatedKernel& SimulatedUnit::kernel(const std::string& kernel_name) {
  const std::lock_guard lock(mutex_);
  const auto it = kernels_.find(kernel_name);
  if (it != kernels_.end()) return it->second;
  const auto begin = std::chrono::steady_clock::now();
  SimulatedKernel kernel;
  kernel.executable = profiler::Executable::compile(compiled_.ptx, kernel_name, mode_, name, checks_);
  if (!declarations_.empty()) kernel.parameters = profiler::parameters_in_bitcode(declarations_, kernel_name);
  kernel.compile_seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return kernels_.emplace(kernel_name, std::move(kernel)).first->second;
}

}  // namespace warpgrain

#endif
