#include "profiler/launch_export.hpp"

#include <fmt/format.h>
#include <fstream>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

void write_bytes(const std::filesystem::path& path, std::string_view bytes) {
  std::ofstream out(path, std::ios::binary);
  if (!out.write(bytes.data(), static_cast<std::streamsize>(bytes.size())).flush())
    throw_input_error(path.string(), "cannot be written", "a folder to write to");
}

}  // namespace

void export_launch(const LaunchFile& file, const LoadedLaunch& launch, const std::filesystem::path& folder) {
  const std::string name = file.path.stem().string();
  LaunchFile exported = file;
  exported.path = folder / (name + ".sim");
  exported.program = name + ".ptx";
  exported.kernel = launch.signature.symbol;
  write_bytes(folder / exported.program, launch.program.ptx);
  for (std::size_t k = 0; k < exported.arguments.size(); ++k) {
    LaunchFileArgument& argument = exported.arguments[k];
    const BoundArgument& bound = launch.arguments[k];
    if (bound.argument.kind != KernelArgument::Kind::local && !argument.is_null) argument.type = bound.type;
    if (argument.file.empty()) continue;
    const std::string file_name = fmt::format("{}.arg{}", name, k);
    std::filesystem::copy_file(argument.file, folder / file_name,
                               std::filesystem::copy_options::overwrite_existing);
    argument.file = file_name;
  }
  write_launch_file(exported);
}

void export_launch(std::string_view ptx, std::string_view kernel, const LaunchShape& shape,
                   std::span<const KernelArgument> arguments, const std::string& name,
                   const std::filesystem::path& folder) {
  LaunchFile file;
  file.path = folder / (name + ".sim");
  file.program = name + ".ptx";
  file.kernel = kernel;
  file.shape = shape;
  write_bytes(folder / file.program, ptx);
  for (const KernelArgument& argument : arguments) {
    const std::size_t k = file.arguments.size();
    switch (argument.kind) {
      case KernelArgument::Kind::buffer:
        file.arguments.push_back(buffer_argument(argument.memory, fmt::format("{}.arg{}", name, k), folder));
        break;
      case KernelArgument::Kind::scalar:
        file.arguments.push_back(scalar_argument(argument.value));
        break;
      case KernelArgument::Kind::local:
        file.arguments.emplace_back().size = argument.local_bytes;
        break;
    }
  }
  write_launch_file(file);
}

}  // namespace warpgrain::profiler
