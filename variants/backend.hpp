#pragma once
// A back end runs a variant of the model on a scene. `host` is the C++ reference, `opencl` any ICD device,
// `cuda` one that CUDA's driver finds, `simt` the simulator. Users hold a Simulation and never ask which it
// is.

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/particle_state.hpp"
#include "core/scene.hpp"
#include "variants/axes.hpp"
#include "variants/kernel_compiler.hpp"

namespace warpgrain {

struct KernelTiming {
  std::string kernel;
  std::uint64_t calls = 0;
  double seconds = 0;  // sum over the calls, device clock where there is one
};

// Forces always belong to the present positions: construction evaluates them once, a step is "integrate, then
// evaluate", so that state() and forces() fit together at any time.
class Simulation {
 public:
  virtual ~Simulation() = default;
  // Advances by n steps. Throws SimulationError naming the particle when one leaves the domain, runs out of
  // contact slots or turns NaN; the step number is in the message.
  virtual void step(std::uint64_t n) = 0;
  virtual ParticleState state() const = 0;  // sorted by id; contact_history as particle_state.hpp says
  virtual ForceState forces() const = 0;    // in the order of state()
  virtual std::uint64_t contact_count() const = 0;  // contacts touching now: a pair once, a wall contact once
  virtual std::uint64_t steps_done() const = 0;
  virtual std::vector<KernelTiming> timings() const = 0;  // in order of first use
  virtual std::string device() const = 0;                 // as the device calls itself
  virtual std::string driver() const { return {}; }       // its version; empty where there is none
};

struct BackendOptions {
  std::string device;    // substring of a device's name, or of an OpenCL platform's; empty: the first PoCL
                         // device, else the first
  unsigned threads = 0;  // host and simt: worker threads, 0 = all cores
  std::string
      kernel_folder;  // files there (below it as below kernels/) shadow the kernels of the build; empty: none
  // Who makes PTX of the kernels: on cuda and simt.
  KernelCompiler compiler = KernelCompiler::clang;
  // opencl: folder for the PTX of each program, made where it is missing; empty: none. A device that makes no
  // PTX is an error then. No other back end takes one.
  std::string ptx_folder;
  // Whether timings() has anything to say. On cuda that costs a little for each launch, and `undisturbed`
  // more: the device waits until a step's launches are queued, so that none is timed while it waits for the
  // host.
  enum class KernelTimes : std::uint8_t { none, plain, undisturbed } kernel_times = KernelTimes::plain;
};

struct Backend {
  std::string_view name;
  std::string_view summary;
  // Empty when it can be used here; else what is missing, in one line.
  std::string (*lacks)();
  // Throws InputError when the variant cannot run on it, the device is not there or a kernel does not
  // compile.
  std::unique_ptr<Simulation> (*create)(const Scene&, const Variant&, const BackendOptions&);
};

std::span<const Backend> backends();
// Throws InputError that lists the valid names.
const Backend& backend(std::string_view name);

}  // namespace warpgrain
