#include "core/error.hpp"

#include <fmt/format.h>

namespace warpgrain {

namespace {

std::string one_line(std::string_view where, std::string_view what, std::string_view expected) {
  std::string message = fmt::format("{}: {}", where, what);
  if (!expected.empty()) message += fmt::format("; expected {}", expected);
  return message;
}

}  // namespace

void throw_input_error(std::string_view where, std::string_view what, std::string_view expected) {
  throw InputError(one_line(where, what, expected));
}

void throw_simulation_error(std::string_view where, std::string_view what, std::string_view expected) {
  throw SimulationError(one_line(where, what, expected));
}

void throw_unknown_name(std::string_view where, std::string_view kind, std::string_view name,
                        std::span<const std::string_view> valid) {
  std::string list;
  for (std::string_view v : valid) list += fmt::format("{}{}", list.empty() ? "" : ", ", v);
  throw InputError(fmt::format("{}: unknown {} '{}'; valid: {}", where, kind, name, list));
}

}  // namespace warpgrain
