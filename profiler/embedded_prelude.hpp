#pragma once
// opencl_prelude.cl as it was at build time.

#include <span>
#include <string_view>

namespace warpgrain::profiler {

struct EmbeddedPrelude {
  std::string_view path;
  std::string_view text;
};

std::span<const EmbeddedPrelude> embedded_preludes();

}  // namespace warpgrain::profiler
