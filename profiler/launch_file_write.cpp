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
