#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "profiler/cuda_frontend.hpp"
#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
#include "profiler/loaded_launch.hpp"
#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {
namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string read_program(const LaunchFile& file) {
  std::ifstream in(file.program, std::ios::binary);
  std::ostringstream text;
  if (!in || !(text << in.rdbuf()))
    throw_input_error(fmt::format("{}: program '{}'", file.path.string(), file.program.string()),
                      "cannot be read", "OpenCL C, CUDA C++ in a .cu file, or PTX in a .ptx file");
  return text.str();
}

enum class Language : std::uint8_t { opencl, cuda, ptx };

Language language_of(const LaunchFile& file) {
  const std::filesystem::path extension = file.program.extension();
  return extension == ".ptx" ? Language::ptx : extension == ".cu" ? Language::cuda : Language::opencl;
}

// The program's text and its PTX, without counters.
LaunchProfile compile(const LaunchFile& file, const std::string& build_options) {
  LaunchProfile profile;
  profile.source = read_program(file);
  profile.source_name = file.program.string();
  const Language language = language_of(file);
  if (language == Language::ptx) {
    profile.ptx = profile.source;
    return profile;
  }
  const std::string options_of_shape =
      language == Language::opencl && !file.shape.is_uniform()
          ? fmt::format("{}{}{}", build_options, build_options.empty() ? "" : " ", smaller_groups_option)
          : build_options;
  CompiledPtx compiled = language == Language::cuda
                             ? compile_cuda(profile.source_name, build_options)
                             : compile_opencl(profile.source, profile.source_name, options_of_shape);
  profile.ptx = std::move(compiled.ptx);
  profile.compiler = std::move(compiled.compiler);
  profile.compile_command = std::move(compiled.command);
  return profile;
}

std::vector<BoundArgument> data_of(const LaunchFile& file, const std::string& build_options,
                                   const LaunchProfile& program,
                                   std::span<const KernelParameter> parameters) {
  std::vector<ParameterDeclaration> declared;
  if (language_of(file) == Language::opencl)
    declared = declared_parameters(program.source, program.source_name, build_options, file.kernel);
  return bind_arguments(file, parameters, declared);
}

}  // namespace

LoadedLaunch load_launch(const LaunchFile& file, const std::string& build_options) {
  const Clock::time_point compile_begin = Clock::now();
  LoadedLaunch launch{compile(file, build_options), {}, file.shape, {}};
  launch.signature = kernel_signature(launch.program.ptx, file.kernel, launch.program.source_name);
  launch.arguments = data_of(file, build_options, launch.program, launch.signature.parameters);
  launch.program.compile_seconds = seconds_since(compile_begin);
  return launch;
}

LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out) {
  LaunchFileResult result;
  LaunchProfile& profile = result.profile;
  const Clock::time_point compile_begin = Clock::now();
  profile = compile(file, build_options);
  const TraceMode mode = options.addresses ? TraceMode::blocks_and_addresses : TraceMode::blocks;
  const auto executable =
      Executable::compile(profile.ptx, file.kernel, mode, profile.source_name, options.checks);
  std::vector<BoundArgument> bound = data_of(file, build_options, profile, executable->parameters());
  profile.compile_seconds = seconds_since(compile_begin);

  std::vector<KernelArgument> arguments;
  for (const BoundArgument& argument : bound) arguments.push_back(argument.argument);
  ProfileOptions named_options = options;
  named_options.source_name = profile.source_name;
  named_options.printed = &out;
  const Clock::time_point run_begin = Clock::now();
  profile.counters = profile_launch(*executable, file.shape, arguments, profile.source, named_options);
  profile.run_seconds = seconds_since(run_begin);

  dump_arguments(file, bound, out);
  for (BoundArgument& argument : bound) result.buffers.push_back(std::move(argument.buffer));
  return result;
}

}  // namespace warpgrain::profiler
