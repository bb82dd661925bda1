// What simulating a force kernel costs: run natively, traced, traced with addresses, merged, checked, and
// replayed over machine code. One thread, so that the figures compare with one core of a CPU OpenCL device.
//
//   POCL_MAX_PTHREAD_COUNT=1 bench_simulator --benchmark_filter=/131072 [--scene=FILE]
//
// The bed is a made-up dense one, or that of a scene file with as many particles as the benchmark's number
// says.

#include <algorithm>
#include <benchmark/benchmark.h>
#include <iostream>
#include <map>
#include <memory>
#include <optional>
#include <random>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <utility>

#include "core/error.hpp"
#include "core/scene.hpp"
#include "profiler/device_buffer.hpp"
#include "profiler/element_type.hpp"
#include "profiler/kernel_declaration.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/profile.hpp"
#include "profiler/sass/ptxas.hpp"
#include "variants/backend.hpp"
#include "variants/device_scene.hpp"
#include "variants/step_plan.hpp"

namespace {

using namespace warpgrain;
using namespace warpgrain::profiler;

const std::string measured_kernel = "force_between_particles";

// A dense bed without settling one: a simple cubic lattice, a little tighter than touching and shaken, so
// that most particles touch six others; in random order, and moving, so that contacts slip.
Scene dense_bed(std::uint64_t n_particles) {
  Scene scene = load_scene("settled_bed", {.particles = n_particles, .seed = std::nullopt});
  ParticleState& particles = scene.particles;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> between(-1, 1);
  const auto any_direction = [&] { return Vector3d(between(random), between(random), between(random)); };
  const double radius = particles.radius[0], spacing = 1.85 * radius;
  const Vector3d room = scene.domain.upper - scene.domain.lower;
  const auto per_edge = [&](int axis) {
    return static_cast<std::size_t>((room[axis] - 2 * radius) / spacing);
  };
  for (std::size_t k = 0; k < particles.size(); ++k) {
    const Vector3d place(static_cast<double>(k % per_edge(0)),
                         static_cast<double>(k / per_edge(0) % per_edge(1)),
                         static_cast<double>(k / per_edge(0) / per_edge(1)));
    particles.position[k] =
        scene.domain.lower + spacing * place + Vector3d::Constant(radius) + 0.2 * radius * any_direction();
    particles.velocity[k] = 0.1 * any_direction();
    particles.angular_velocity[k] = any_direction();
  }
  scene.time_step = 1e-9;  // steps leave the bed as it is
  std::shuffle(particles.position.begin(), particles.position.end(), random);
  return scene;
}

std::optional<Scene> given_scene;

Scene bed(std::uint64_t n_particles) {
  if (given_scene && given_scene->particles.size() == n_particles) return *given_scene;
  return dense_bed(n_particles);
}

const Variant& variant() {
  static const Variant variant = Variant::parse("branchy/cells/cell/fp32/default");
  return variant;
}

// The force kernel of the first step, with everything before it done.
class ForceKernel {
 public:
  explicit ForceKernel(std::uint64_t n_particles) {
    const Scene scene = bed(n_particles);
    DeviceScene device = lay_out(scene, variant());
    const StepPlan plan = make_step_plan(scene, variant(), device, KernelSources());
    for (std::size_t k = 0; k < n_device_arrays; ++k) {
      const auto array = static_cast<DeviceArray>(k);
      arrays_[array] = DeviceBuffer(device.bytes[array]);
      std::copy(device.contents[array].begin(), device.contents[array].end(), arrays_[array].bytes().begin());
    }
    for (const SourceUnit& unit : plan.units) {
      ptx_.push_back(compile_opencl(unit.text, "unit.cl", unit.build_options).ptx);
      declarations_.push_back(declaration_bitcode(unit.text, "unit.cl", unit.build_options));
    }
    std::vector<PlanEntry> entries = plan.map;
    entries.insert(entries.end(), plan.forces.begin(), plan.forces.end());
    for (const PlanEntry& entry : entries) {
      if (const auto* swap = std::get_if<ArraySwap>(&entry)) {
        std::swap(arrays_[swap->first], arrays_[swap->second]);
        continue;
      }
      const auto& launch = std::get<KernelLaunch>(entry);
      shape_ = {{launch.global_size, 1, 1}, {static_cast<std::uint32_t>(launch.local_size), 1, 1}};
      arguments_ = arguments_of(launch);
      if (launch.kernel == measured_kernel) {
        unit_ = launch.unit;
        return;
      }
      run(executable(launch.unit, launch.kernel, TraceMode::none, Checks::off));
    }
    throw std::logic_error("the plan lacks the measured kernel");
  }

  const Executable& executable(TraceMode mode, Checks checks) {
    return executable(unit_, measured_kernel, mode, checks);
  }

  void run(const Executable& executable) const {
    const auto runner = executable.runner(shape_, arguments_);
    for (std::uint64_t group = 0; group < shape_.group_count()[0]; ++group)
      benchmark::DoNotOptimize(runner->run({group, 0, 0}).data());
  }

  LaunchCounters profile(const Executable& executable, const std::vector<WhatIf>& what_if = {},
                         WeightOptions weights = {}) const {
    ProfileOptions options;
    options.threads = 1;
    options.weights = std::move(weights);
    options.what_if = what_if;
    return profile_launch(executable, shape_, arguments_, "", options);
  }

 private:
  std::vector<KernelArgument> arguments_of(const KernelLaunch& launch) {
    const auto declared = parameters_in_bitcode(declarations_[launch.unit], launch.kernel);
    std::vector<KernelArgument> arguments;
    for (const LaunchArgument& argument : launch.arguments) {
      if (const auto* array = std::get_if<DeviceArray>(&argument)) {
        arguments.push_back(KernelArgument::buffer(arrays_[*array].bytes()));
      } else {
        arguments.push_back(KernelArgument::scalar(std::get<std::vector<std::byte>>(argument)));
      }
      arguments.back().vector_bytes = vector_bytes_of_parameter(declared.at(arguments.size() - 1).type);
    }
    return arguments;
  }

  const Executable& executable(std::size_t unit, const std::string& kernel, TraceMode mode, Checks checks) {
    auto& compiled = executables_[{kernel, mode, checks}];
    if (!compiled) compiled = Executable::compile(ptx_[unit], kernel, mode, kernel, checks);
    return *compiled;
  }

  PerArray<DeviceBuffer> arrays_;
  std::vector<std::string> ptx_;           // of the plan's units
  std::vector<std::string> declarations_;  // of the same, as bitcode
  std::map<std::tuple<std::string, TraceMode, Checks>, std::unique_ptr<Executable>> executables_;
  std::size_t unit_ = 0;
  LaunchShape shape_;
  std::vector<KernelArgument> arguments_;
};

ForceKernel& force_kernel(std::int64_t n_particles) {
  static std::map<std::int64_t, std::unique_ptr<ForceKernel>> kernels;
  auto& kernel = kernels[n_particles];
  if (!kernel) kernel = std::make_unique<ForceKernel>(static_cast<std::uint64_t>(n_particles));
  return *kernel;
}

void run_kernel(benchmark::State& state, TraceMode mode) {
  ForceKernel& kernel = force_kernel(state.range(0));
  const Executable& executable = kernel.executable(mode, Checks::off);
  for (auto _ : state) kernel.run(executable);
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

void run_and_merge(benchmark::State& state, TraceMode mode, Checks checks) {
  ForceKernel& kernel = force_kernel(state.range(0));
  const Executable& executable = kernel.executable(mode, checks);
  LaunchCounters counters;
  for (auto _ : state) counters = kernel.profile(executable);
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["efficiency"] = counters.totals.simt_efficiency(counters.warp_width);
  const MemoryCounters& loads = counters.totals.global_load;
  if (loads.requests != 0)
    state.counters["sectors_per_load"] =
        static_cast<double>(loads.sectors) / static_cast<double>(loads.requests);
}

// Compare with run_and_merge: the same, and the replay. ptxas runs once, before the first reading.
void run_and_replay(benchmark::State& state, TraceMode mode) {
  if (!sass::find_ptxas()) {
    state.SkipWithError("ptxas is not installed");
    return;
  }
  ForceKernel& kernel = force_kernel(state.range(0));
  const Executable& executable = kernel.executable(mode, Checks::off);
  const WeightOptions weights{WeightOptions::Kind::sass, "sm_90"};
  LaunchCounters counters = kernel.profile(executable, {}, weights);
  if (!counters.weights.sass) {
    state.SkipWithError(counters.weights.reason.c_str());
    return;
  }
  for (auto _ : state) counters = kernel.profile(executable, {}, weights);
  state.SetItemsProcessed(state.iterations() * state.range(0));
  state.counters["efficiency"] = counters.totals.simt_efficiency(counters.warp_width);
}

std::vector<WhatIf> four_widths_and_three_policies(const ThreadOrder& order) {
  std::vector<WhatIf> questions;
  for (const std::uint32_t width : {8U, 16U, 32U, 64U})
    for (const MergePolicy policy : {MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc})
      questions.push_back({width, policy, order, 0});
  return questions;
}

// Twelve other warps beside: compare with run_and_merge.
void run_and_ask(benchmark::State& state, TraceMode mode, const char* order) {
  ForceKernel& kernel = force_kernel(state.range(0));
  const Executable& executable = kernel.executable(mode, Checks::off);
  const auto questions = four_widths_and_three_policies(ThreadOrder::from_name(order, "order"));
  for (auto _ : state) benchmark::DoNotOptimize(kernel.profile(executable, questions).what_if.data());
  state.SetItemsProcessed(state.iterations() * state.range(0));
}

// The same kernel on the OpenCL device, by its clock: what the simulation is measured against.
void run_on_opencl(benchmark::State& state) {
  if (const std::string missing = backend("opencl").lacks(); !missing.empty()) {
    state.SkipWithError(missing.c_str());
    return;
  }
  const auto simulation =
      backend("opencl").create(bed(static_cast<std::uint64_t>(state.range(0))), variant(), {});
  const auto seconds = [&] {
    for (const KernelTiming& timing : simulation->timings())
      if (timing.kernel == measured_kernel) return timing.seconds;
    throw std::logic_error("the measured kernel has no timing");
  };
  for (auto _ : state) {
    const double before = seconds();
    simulation->step(1);
    state.SetIterationTime(seconds() - before);
  }
  state.SetLabel(simulation->device());
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->Arg(1 << 14)->Arg(1 << 17)->Unit(benchmark::kMillisecond);
}

BENCHMARK(run_on_opencl)->Apply(sizes)->UseManualTime();
BENCHMARK_CAPTURE(run_kernel, native, TraceMode::none)->Apply(sizes);
BENCHMARK_CAPTURE(run_kernel, blocks, TraceMode::blocks)->Apply(sizes);
BENCHMARK_CAPTURE(run_kernel, addresses, TraceMode::blocks_and_addresses)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_merge, blocks, TraceMode::blocks, Checks::off)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_merge, blocks_checked, TraceMode::blocks, Checks::on)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_merge, addresses, TraceMode::blocks_and_addresses, Checks::off)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_merge, addresses_checked, TraceMode::blocks_and_addresses, Checks::on)
    ->Apply(sizes);
BENCHMARK_CAPTURE(run_and_replay, blocks, TraceMode::blocks)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_replay, addresses, TraceMode::blocks_and_addresses)->Apply(sizes);
BENCHMARK_CAPTURE(run_and_ask, blocks, TraceMode::blocks, "launched")->Apply(sizes);
BENCHMARK_CAPTURE(run_and_ask, addresses, TraceMode::blocks_and_addresses, "launched")->Apply(sizes);
BENCHMARK_CAPTURE(run_and_ask, sorted, TraceMode::blocks, "sorted")->Apply(sizes);

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  constexpr std::string_view option = "--scene=";
  if (argc == 2 && std::string_view(argv[1]).starts_with(option)) {
    try {
      given_scene = load_scene(argv[1] + option.size());
    } catch (const InputError& error) {
      std::cerr << error.what() << '\n';
      return 2;
    }
  } else if (benchmark::ReportUnrecognizedArguments(argc, argv)) {
    return 2;
  }
  benchmark::RunSpecifiedBenchmarks();
}
