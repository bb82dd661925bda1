#pragma once
// Holds the simulator against the interpreter: the same launch in both, and every difference as a line.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/launch.hpp"
#include "profiler/merge_policy.hpp"

namespace warpgrain::oracle {

struct Setting {
  profiler::MergePolicy policy = profiler::MergePolicy::loop_postdom;
  std::uint32_t warp_width = 32;
};

// Every policy at widths 8 and 32.
std::span<const Setting> all_settings();

// Runs a kernel of a PTX module once in the simulator and once a setting in the interpreter. Buffers end up
// as the simulator leaves them; they must be aligned as DeviceBuffer is. Differences in how often each
// instruction was issued, by number of active lanes; in divergent branches and lanes that took them; in
// requests, sectors and useful bytes of each access; and in the buffers. Empty when there are none; only the
// first ones when there are many. What the interpreter refuses is a std::runtime_error, an
// UnknownInstruction (modifiers.hpp) where it lacks something.
std::vector<std::string> differences(std::string_view ptx, std::string_view kernel,
                                     const profiler::LaunchShape& shape,
                                     std::span<const profiler::KernelArgument> arguments,
                                     std::span<const Setting> settings = all_settings());

}  // namespace warpgrain::oracle
