#include <chrono>

#include "profiler/compiled_launches.hpp"
#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/loaded_launch.hpp"

namespace warpgrain::profiler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

}  // namespace

LoadedLaunch load_launch(const LaunchFile& file, const std::string& build_options) {
  CompiledLaunches compiled;
  const Clock::time_point compile_begin = Clock::now();
  LoadedLaunch launch{compiled.program(file, build_options), {}, file.shape, {}};
  launch.signature = kernel_signature(launch.program.ptx, file.kernel, launch.program.source_name);
  launch.arguments =
      bind_arguments(file, launch.signature.parameters, compiled.declared(file, build_options));
  launch.program.compile_seconds = seconds_since(compile_begin);
  return launch;
}

LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out) {
  CompiledLaunches compiled;
  return profile_launch_file(file, build_options, options, out, compiled);
}

LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out,
                                     CompiledLaunches& compiled) {
  LaunchFileResult result;
  LaunchProfile& profile = result.profile;
  const Clock::time_point compile_begin = Clock::now();
  profile = compiled.program(file, build_options);
  const TraceMode mode = options.addresses ? TraceMode::blocks_and_addresses : TraceMode::blocks;
  const Executable& executable = compiled.kernel(file, build_options, mode, options.checks);
  std::vector<BoundArgument> bound =
      bind_arguments(file, executable.parameters(), compiled.declared(file, build_options));
  profile.compile_seconds = seconds_since(compile_begin);

  std::vector<KernelArgument> arguments;
  for (const BoundArgument& argument : bound) arguments.push_back(argument.argument);
  ProfileOptions named_options = options;
  named_options.source_name = profile.source_name;
  named_options.printed = &out;
  const Clock::time_point run_begin = Clock::now();
  profile.counters = profile_launch(executable, file.shape, arguments, profile.source, named_options);
  profile.run_seconds = seconds_since(run_begin);

  dump_arguments(file, bound, out);
  for (BoundArgument& argument : bound) result.buffers.push_back(std::move(argument.buffer));
  return result;
}

}  // namespace warpgrain::profiler
