#pragma once
// Launches as files that another machine runs without a compiler of their language: NAME.sim, NAME.ptx, and
// NAME.argK for what cannot be said in the launch file.

#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "profiler/launch_file.hpp"
#include "profiler/loaded_launch.hpp"

namespace warpgrain::profiler {

// Of a launch file: its arguments as they are said there. The folder is there. Throws InputError when a file
// cannot be written.
void export_launch(const LaunchFile& file, const LoadedLaunch& launch, const std::filesystem::path& folder);

// Of any launch: buffers with their present contents. `kernel` is the name in the PTX.
void export_launch(std::string_view ptx, std::string_view kernel, const LaunchShape& shape,
                   std::span<const KernelArgument> arguments, const std::string& name,
                   const std::filesystem::path& folder);

}  // namespace warpgrain::profiler
