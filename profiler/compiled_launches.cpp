#include "profiler/compiled_launches.hpp"

#include <fmt/format.h>
#include <fstream>
#include <sstream>

#include "core/error.hpp"
#include "profiler/cuda_frontend.hpp"
#include "profiler/kernel_declaration.hpp"

namespace warpgrain::profiler {
namespace {

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

std::string joined(const std::string& first, const std::string& second) {
  return first.empty() || second.empty() ? first + second : first + ' ' + second;
}

std::string name_of(const LaunchFile& file) {
  return file.program_name.empty() ? file.program.string() : file.program_name;
}

// Those of the file and of the call, and what the shape asks for.
std::string options_of(const LaunchFile& file, const std::string& build_options) {
  const std::string options = joined(file.build_options, build_options);
  return language_of(file) == Language::opencl && !file.shape.is_uniform()
             ? joined(options, std::string(smaller_groups_option))
             : options;
}

LaunchProfile compile(const LaunchFile& file, const std::string& options) {
  LaunchProfile profile;
  profile.source = read_program(file);
  profile.source_name = name_of(file);
  const Language language = language_of(file);
  if (language == Language::ptx) {
    profile.ptx = profile.source;
    return profile;
  }
  CompiledPtx compiled = language == Language::cuda
                             ? compile_cuda(file.program.string(), options)
                             : compile_opencl(profile.source, profile.source_name, options);
  profile.ptx = std::move(compiled.ptx);
  profile.compiler = std::move(compiled.compiler);
  profile.compile_command = std::move(compiled.command);
  return profile;
}

}  // namespace

const LaunchProfile& CompiledLaunches::program(const LaunchFile& file, const std::string& build_options) {
  const ProgramKey key{file.program.string(), options_of(file, build_options)};
  const auto found = programs_.find(key);
  return found != programs_.end() ? found->second
                                  : programs_.emplace(key, compile(file, key.second)).first->second;
}

std::vector<ParameterDeclaration> CompiledLaunches::declared(const LaunchFile& file,
                                                             const std::string& build_options) {
  if (language_of(file) != Language::opencl) return {};
  const ProgramKey key{file.program.string(), joined(file.build_options, build_options)};
  auto found = declarations_.find(key);
  if (found == declarations_.end())
    found =
        declarations_
            .emplace(key, declaration_bitcode(program(file, build_options).source, name_of(file), key.second))
            .first;
  return parameters_in_bitcode(found->second, file.kernel);
}

const Executable& CompiledLaunches::kernel(const LaunchFile& file, const std::string& build_options,
                                           TraceMode mode, Checks checks) {
  const LaunchProfile& of_program = program(file, build_options);
  std::unique_ptr<Executable>& kernel =
      kernels_[{{file.program.string(), options_of(file, build_options)}, file.kernel, mode, checks}];
  if (!kernel)
    kernel = Executable::compile(of_program.ptx, file.kernel, mode, of_program.source_name, checks);
  return *kernel;
}

}  // namespace warpgrain::profiler
