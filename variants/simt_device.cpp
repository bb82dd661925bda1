#include "variants/simt_device.hpp"

#include "core/error.hpp"

#ifdef WARPGRAIN_HAS_SIMULATOR

#include <algorithm>
#include <atomic>
#include <chrono>
#include <optional>
#include <set>
#include <thread>
#include <utility>

#include "core/parallel_ranges.hpp"
#include "profiler/element_type.hpp"
#include "profiler/launch_export.hpp"
#include "variants/simulated_unit.hpp"
#include "variants/simulator_arrays.hpp"

namespace warpgrain {
namespace {

using profiler::Executable;
using profiler::KernelArgument;
using profiler::LaunchProfile;
using profiler::LaunchShape;

double seconds_since(std::chrono::steady_clock::time_point begin) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

class SimulatedDevice : public OverSimulatorArrays<SimtDevice> {
 public:
  SimulatedDevice(profiler::TraceMode mode, KernelCompiler compiler, profiler::Checks checks,
                  unsigned threads, Approximations approximations)
      : mode_(mode),
        compiler_(compiler),
        checks_(checks),
        approximations_(approximations),
        threads_(threads > 0 ? threads : std::max(1u, std::thread::hardware_concurrency())) {}

  void build(const std::vector<SourceUnit>& units) override {
    for (const SourceUnit& unit : units)
      units_.push_back(SimulatedUnit::of(unit, compiler_, mode_, checks_, approximations_));
  }

  void launch(const KernelLaunch& launch) override {
    SimulatedUnit& unit = *units_[launch.unit];
    const SimulatedKernel& kernel = unit.kernel(launch.kernel);
    const LaunchShape shape = shape_of(launch);
    std::vector<KernelArgument> arguments = arguments_of(launch);
    for (std::size_t i = 0; i < std::min(arguments.size(), kernel.parameters.size()); ++i) {
      arguments[i].name = kernel.parameters[i].name;
      arguments[i].vector_bytes = profiler::vector_bytes_of_parameter(kernel.parameters[i].type);
    }
    if (!export_folder_.empty() && exported_.insert(launch.kernel).second)
      profiler::export_launch(unit.compiled().ptx, launch.kernel, shape, arguments, launch.kernel,
                              export_folder_);
    const auto begin = std::chrono::steady_clock::now();
    if (profile_options_) {
      profile(unit, kernel, shape, arguments);
    } else {
      run(*kernel.executable, shape, arguments);
    }
    KernelTiming& timing = timing_of(launch.kernel);
    timing.calls += 1;
    timing.seconds += seconds_since(begin);
  }

  void finish() override {}
  std::vector<KernelTiming> timings() const override { return timings_; }
  std::string name() const override { return "SIMT simulator"; }

  void record(const profiler::ProfileOptions& options, const std::filesystem::path& export_folder) override {
    profile_options_ = options;
    export_folder_ = export_folder;
    if (options.threads == 0) profile_options_->threads = threads_;
  }
  std::vector<LaunchProfile> take_profiles() override { return std::exchange(profiles_, {}); }

 private:
  KernelTiming& timing_of(const std::string& kernel) {
    const auto found = std::ranges::find(timings_, kernel, &KernelTiming::kernel);
    return found == timings_.end() ? timings_.emplace_back(KernelTiming{kernel, 0, 0}) : *found;
  }

  void profile(const SimulatedUnit& unit, const SimulatedKernel& kernel, const LaunchShape& shape,
               std::span<const KernelArgument> arguments) {
    const auto begin = std::chrono::steady_clock::now();
    LaunchProfile launch;
    launch.counters =
        profiler::profile_launch(*kernel.executable, shape, arguments, unit.text(), *profile_options_);
    launch.run_seconds = seconds_since(begin);
    launch.source = unit.text();
    launch.source_name = SimulatedUnit::name;
    launch.ptx = unit.compiled().ptx;
    launch.compiler = unit.compiled().compiler;
    launch.compile_command = unit.compiled().command;
    launch.compile_seconds = kernel.compile_seconds;
    profiles_.push_back(std::move(launch));
  }

  // Runs the work-groups without counting anything. No kernel's work-groups wait for one another.
  void run(const Executable& executable, const LaunchShape& shape,
           std::span<const KernelArgument> arguments) const {
    const std::uint64_t n_groups = shape.group_count()[0];
    std::atomic<std::uint64_t> next_group = 0;
    for_each_range(std::min<std::uint64_t>(threads_, n_groups), [&](std::size_t) {
      const auto runner = executable.runner(shape, arguments);
      for (std::uint64_t group = next_group++; group < n_groups; group = next_group++)
        runner->run({group, 0, 0});
    });
  }

  profiler::TraceMode mode_;
  KernelCompiler compiler_;
  profiler::Checks checks_;
  Approximations approximations_;
  unsigned threads_;
  std::vector<std::shared_ptr<SimulatedUnit>> units_;
  std::vector<KernelTiming> timings_;
  std::optional<profiler::ProfileOptions> profile_options_;
  std::vector<LaunchProfile> profiles_;
  std::filesystem::path export_folder_;
  std::set<std::string> exported_;  // kernels
};

}  // namespace

std::string simulator_lacks() { return {}; }

std::unique_ptr<SimtDevice> make_simt_device(profiler::TraceMode mode, unsigned threads,
                                             KernelCompiler compiler, profiler::Checks checks,
                                             Approximations approximations) {
  return std::make_unique<SimulatedDevice>(mode, compiler, checks, threads, approximations);
}

}  // namespace warpgrain

#else

namespace warpgrain {

std::string simulator_lacks() { return "built without the simulator (WARPGRAIN_SIMULATOR=OFF)"; }

std::unique_ptr<SimtDevice> make_simt_device(profiler::TraceMode, unsigned, KernelCompiler, profiler::Checks,
                                             Approximations) {
  throw_input_error("simt", simulator_lacks());
}

}  // namespace warpgrain

#endif
