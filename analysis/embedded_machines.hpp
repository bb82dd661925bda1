#pragma once
// The files of profiler/machines/ as they were at build time, sorted by path.

#include <span>
#include <string_view>

namespace warpgrain {

struct EmbeddedMachine {
  std::string_view path;  // "hopper_h100.json"
  std::string_view text;
};

std::span<const EmbeddedMachine> embedded_machines();

}  // namespace warpgrain
