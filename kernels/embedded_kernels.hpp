#pragma once
// The .cl and .h files of this folder as they were at build time, by path relative to it.

#include <span>
#include <string_view>

namespace warpgrain {

struct EmbeddedKernel {
  std::string_view path;  // "contact/branchy.cl"
  std::string_view text;
};

std::span<const EmbeddedKernel> embedded_kernels();

}  // namespace warpgrain
