#pragma once
// Programs that hold many expressions, of which a launch evaluates one: compiled once for all of them.

#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::profiler::builtins {

struct Expression {
  std::string text;  // over x, y, z, vectors of `width`, and n, the index of the work-item
  std::string type;  // of the result's elements
};

// kernel void measured(global void* results, xs, ys, zs, int which): work-item i takes elements i width to
// (i + 1) width of the inputs of type `type` and writes as many.
inline std::string switch_program(std::string_view type, std::uint32_t width,
                                  const std::vector<Expression>& expressions) {
  const std::string n = width == 1 ? "" : std::to_string(width);
  const auto loaded = [&](std::string_view array) {
    return width == 1 ? fmt::format("{}[n]", array) : fmt::format("vload{}(n, {})", width, array);
  };
  std::string text = fmt::format(
      "typedef {0} T;\ntypedef {0}{1} V;\n"
      "kernel void measured(global void* results, global const T* xs, global const T* ys, global const T* "
      "zs,\n"
      "                     int which) {{\n  const size_t n = get_global_id(0);\n"
      "  const V x = {2}, y = {3}, z = {4};\n  switch (which) {{\n",
      type, n, loaded("xs"), loaded("ys"), loaded("zs"));
  for (std::size_t e = 0; e < expressions.size(); ++e)
    text += width == 1 ? fmt::format("    case {}: ((global {}*)results)[n] = {}; break;\n", e,
                                     expressions[e].type, expressions[e].text)
                       : fmt::format("    case {}: vstore{}({}, n, (global {}*)results); break;\n", e, width,
                                     expressions[e].text, expressions[e].type);
  return text + "  }\n}\n";
}

}  // namespace warpgrain::profiler::builtins
