#pragma once
// The files of scenes/ as they were at build time, sorted by path.

#include <span>
#include <string_view>

namespace warpgrain {

struct EmbeddedScene {
  std::string_view path;  // "slit.json"
  std::string_view text;
};

std::span<const EmbeddedScene> embedded_scenes();

}  // namespace warpgrain
