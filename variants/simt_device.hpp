#pragma once
// The simulator as a device: it runs the same kernels, compiled to PTX, and counts their warps when asked to.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/profile.hpp"
#include "variants/compute_device.hpp"

namespace warpgrain {

// What PTX's approximate functions of floats give: the exact result, rounded once, or one that is off by what
// the PTX ISA allows (profiler/approximate_ptx.hpp).
enum class Approximations : std::uint8_t { exact, as_far_off_as_allowed };

class SimtDevice : public ComputeDevice {
 public:
  // Profiles the launches from here on. Needs a device made with a mode that leaves traces. The first launch
  // of each kernel goes to `export_folder`, named after the kernel, with the data that it begins with; empty:
  // none does.
  virtual void record(const profiler::ProfileOptions& options,
                      const std::filesystem::path& export_folder = {}) = 0;
  // Of the launches since record(), in order.
  virtual std::vector<profiler::LaunchProfile> take_profiles() = 0;
};

// Empty when the simulator is part of this build; else one line that says it is not.
std::string simulator_lacks();

// `threads`: worker threads, 0 = all cores. With checks, profiles tell what is wrong with the kernels. Throws
// InputError when simulator_lacks().
std::unique_ptr<SimtDevice> make_simt_device(profiler::TraceMode mode, unsigned threads,
                                             KernelCompiler compiler = KernelCompiler::clang,
                                             profiler::Checks checks = profiler::Checks::off,
                                             Approximations approximations = Approximations::exact);

}  // namespace warpgrain
