#pragma once
// A launch as its file describes it, compiled to PTX and with its data, for whoever runs it: the simulator or
// a device.

#include <string>
#include <vector>

#include "profiler/kernel_signature.hpp"
#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/profile.hpp"

namespace warpgrain::profiler {

struct LoadedLaunch {
  LaunchProfile program;  // without counters
  KernelSignature signature;
  LaunchShape shape;
  std::vector<BoundArgument> arguments;  // one a parameter of the signature
};

// Throws InputError as profile_launch_file does.
LoadedLaunch load_launch(const LaunchFile& file, const std::string& build_options);

}  // namespace warpgrain::profiler
