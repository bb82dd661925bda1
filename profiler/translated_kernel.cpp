#include "profiler/translated_kernel.hpp"

#include <algorithm>
#include <fmt/format.h>

namespace warpgrain::profiler {

std::string TranslatedKernel::place() const { return fmt::format("{}: kernel '{}'", where, graph.kernel); }

DiagnosticPlace TranslatedKernel::source_of(std::uint32_t ptx_line) const {
  const auto found = std::find_if(statement_lines.begin(), statement_lines.end(),
                                  [&](const auto& entry) { return entry.first == ptx_line; });
  if (found == statement_lines.end() || found->second.line == 0 || found->second.file >= graph.files.size())
    return {{}, 0, ptx_line};
  return {graph.files[found->second.file], found->second.line, ptx_line};
}

}  // namespace warpgrain::profiler
