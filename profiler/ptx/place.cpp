#include "profiler/ptx/place.hpp"

#include <fmt/format.h>

namespace warpgrain::profiler::ptx {

std::string place(std::string_view where, std::uint32_t line) {
  return fmt::format("{}, PTX line {}", where, line);
}

std::string place(std::string_view where, const Module& module, const Statement& statement) {
  const auto file = module.files.find(statement.location.file);
  if (statement.location.line == 0 || file == module.files.end()) return place(where, statement.line);
  return fmt::format("{} ({}:{})", place(where, statement.line), file->second, statement.location.line);
}

}  // namespace warpgrain::profiler::ptx
