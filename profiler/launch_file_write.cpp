#include <algorithm>
#include <fmt/format.h>
#include <fstream>

#include "core/error.hpp"
#include "profiler/launch_file.hpp"

namespace warpgrain::profiler {
namespace {

std::string header(const LaunchFileArgument& argument) {
  std::string text = argument.is_null ? "<null" : fmt::format("<size={}", argument.size);
  if (argument.type) text += fmt::format(" {}", element_name(*argument.type));
  if (!argument.fill.empty()) text += fmt::format(" fill={}", argument.fill);
  if (!argument.range.empty()) text += fmt::format(" range={}", argument.range);
  if (!argument.file.empty()) text += fmt::format(" file={}", argument.file.string());
  for (const auto& [is_set, word] : {std::pair{argument.hex, " hex"},
                                     {argument.no_init, " noinit"},
                                     {argument.read_only, " ro"},
                                     {argument.write_only, " wo"},
                                     {argument.dump, " dump"}})
    if (is_set) text += word;
  return text + ">";
}

}  // namespace

LaunchFileArgument scalar_argument(std::span<const std::byte> value) {
  LaunchFileArgument argument;
  argument.size = value.size();
  argument.type = ElementType::u8;
  argument.hex = true;
  for (const std::byte byte : value) argument.values.push_back({fmt::format("{:02x}", byte), 0});
  return argument;
}

LaunchFileArgument buffer_argument(std::span<const std::byte> bytes, const std::string& name,
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
  const std::filesystem::path path = folder / name;
  std::ofstream out(path, std::ios::binary);
  const auto size = static_cast<std::streamsize>(bytes.size());
  if (!out.write(reinterpret_cast<const char*>(bytes.data()), size).flush())
    throw_input_error(path.string(), "cannot be written", "a folder to write to");
  argument.file = name;
  return argument;
}

std::filesystem::path options_file(const std::filesystem::path& program) {
  return program.string() + ".options";
}

void write_launch_file(const LaunchFile& file) {
  const auto& [x, y, z] = file.shape.global_size;
  const auto& [local_x, local_y, local_z] = file.shape.local_size;
  std::ofstream out(file.path);
  out << fmt::format("{}\n{}\n{} {} {}\n{} {} {}\n", file.program.string(), file.kernel, x, y, z, local_x,
                     local_y, local_z);
  for (const LaunchFileArgument& argument : file.arguments) {
    out << header(argument);
    for (const LaunchFileArgument::Value& value : argument.values) out << ' ' << value.text;
    out << '\n';
  }
  if (!out.flush()) throw_input_error(file.path.string(), "cannot be written", "a folder to write to");
}

}  // namespace warpgrain::profiler
