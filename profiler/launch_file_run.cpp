#include <chrono>
#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "profiler/cuda_frontend.hpp"
#include "profiler/launch_arguments.hpp"
#include "profiler/launch_file.hpp"
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

// Sets the PTX of the profile's source, and how it was made.
void compile(Language language, const std::string& build_options, LaunchProfile& profile) {
  if (language == Language::ptx) {
    profile.ptx = profile.source;
    return;
  }
  CompiledPtx compiled = language == Language::cuda
                             ? compile_cuda(profile.source_name, build_options)
                             : compile_opencl(profile.source, profile.source_name, build_options);
  profile.ptx = std::move(compiled.ptx);
  profile.compiler = std::move(compiled.compiler);
  profile.compile_command = std::move(compiled.command);
}

}  // namespace

LaunchFileResult profile_launch_file(const LaunchFile& file, const std::string& build_options,
                                     const ProfileOptions& options, std::ostream& out) {
  LaunchFileResult result;
  LaunchProfile& profile = result.profile;
  profile.source = read_program(file);
  profile.source_name = file.program.string();

  const Clock::time_point compile_begin = Clock::now();
  std::vector<ParameterDeclaration> declared;
  const Language language = language_of(file);
  const std::string options_of_shape =
      language == Language::opencl && !file.shape.is_uniform()
          ? fmt::format("{}{}{}", build_options, build_options.empty() ? "" : " ", smaller_groups_option)
          : build_options;
  compile(language, options_of_shape, profile);
  const TraceMode mode = options.addresses ? TraceMode::blocks_and_addresses : TraceMode::blocks;
  const auto executable =
      Executable::compile(profile.ptx, file.kernel, mode, profile.source_name, options.checks);
  if (language == Language::opencl)
    declared = declared_parameters(profile.source, profile.source_name, build_options, file.kernel);
  profile.compile_seconds = seconds_since(compile_begin);

  std::vector<BoundArgument> bound = bind_arguments(file, executable->parameters(), declared);
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
