#include "profiler/launch_export.hpp"

#include <algorithm>
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

LaunchFileArgument scalar(std::span<const std::byte> value) {
  LaunchFileArgument argument;
  argument.size = value.size();
  argument.type = ElementType::u8;
  argument.hex = true;
  for (const std::byte byte : value) argument.values.push_back({fmt::format("{:02x}", byte), 0});
  return argument;
}

LaunchFileArgument buffer(std::span<const std::byte> bytes, const std::string& file_name,
                          const std::filesystem::path& folder) {
  LaunchFileArgument argument;
  argument.size = bytes.size();
  argument.type = ElementType::u8;
  argument.is_null = bytes.empty();
  if (bytes.empty()) return argument;
  if (std::ranges::all_of(bytes, [](std::byte byte) { return byte == std::byte{0}; })) {
    argument.fill = std::string(1, '0');
    return argument;
  }
  write_bytes(folder / file_name, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
  argument.file = file_name;
  return argument;
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
  LaunchFile file{folder / (name + ".sim"), name + ".ptx", std::string(kernel), shape, {}};
  write_bytes(folder / file.program, ptx);
  for (const KernelArgument& argument : arguments) {
    const std::size_t k = file.arguments.size();
    switch (argument.kind) {
      case KernelArgument::Kind::buffer:
        file.arguments.push_back(buffer(argument.memory, fmt::format("{}.arg{}", name, k), folder));
        break;
      case KernelArgument::Kind::scalar:
        file.arguments.push_back(scalar(argument.value));
        break;
      case KernelArgument::Kind::local:
        file.arguments.emplace_back().size = argument.local_bytes;
        break;
    }
  }
  write_launch_file(file);
}

}  // namespace warpgrain::profiler
