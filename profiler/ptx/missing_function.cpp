#include "profiler/ptx/missing_function.hpp"

#include <array>
#include <charconv>
#include <fmt/format.h>

namespace warpgrain::profiler::ptx {
namespace {

// The name in `_Z11read_imagef...`; anything else as it is.
std::string_view plain_name(std::string_view symbol) {
  if (!symbol.starts_with("_Z")) return symbol;
  std::size_t length = 0;
  const auto [end, error] = std::from_chars(symbol.data() + 2, symbol.data() + symbol.size(), length);
  const auto begin = static_cast<std::size_t>(end - symbol.data());
  if (error != std::errc{} || begin + length > symbol.size()) return symbol;
  return symbol.substr(begin, length);
}

}  // namespace

std::string missing_function(std::string_view symbol) {
  struct Subject {
    std::string_view part;  // of the function's name
    std::string_view subject;
  };
  static constexpr std::array<Subject, 15> subjects{{
      {"read_image", "images and samplers are"},
      {"write_image", "images and samplers are"},
      {"get_image", "images and samplers are"},
      {"sampler", "images and samplers are"},
      {"pipe", "pipes are"},
      {"enqueue", "device-side enqueue is"},
      {"get_default_queue", "device-side enqueue is"},
      {"ndrange", "device-side enqueue is"},
      {"event", "device-side enqueue is"},
      {"get_kernel_", "device-side enqueue is"},
      {"sub_group", "sub-groups are"},
      {"work_group_reduce", "functions of whole work-groups are"},
      {"work_group_scan", "functions of whole work-groups are"},
      {"work_group_a", "functions of whole work-groups are"},
      {"work_group_broadcast", "functions of whole work-groups are"},
  }};
  const std::string_view name = plain_name(symbol);
  for (const Subject& s : subjects)
    if (name.find(s.part) != std::string_view::npos)
      return fmt::format("'{}': {} not carried", name, s.subject);
  return fmt::format("call of '{}', which has no body here", name);
}

}  // namespace warpgrain::profiler::ptx
