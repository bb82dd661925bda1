#include "profiler/sass/line_directives.hpp"

#include <cstdint>
#include <fmt/format.h>
#include <iterator>
#include <set>

#include "profiler/ptx/parser.hpp"

namespace warpgrain::profiler::sass {
namespace {

std::set<std::uint32_t> statement_lines(std::string_view text) {
  const ptx::Module module = ptx::parse(text, "PTX");
  std::set<std::uint32_t> lines;
  for (const ptx::Function& function : module.functions)
    for (const ptx::Statement& statement : function.statements) lines.insert(statement.line);
  return lines;
}

}  // namespace

std::string with_line_directives(std::string_view ptx) {
  const std::set<std::uint32_t> lines = statement_lines(ptx);
  std::string result;
  bool in_debug_section = false;
  std::uint32_t number = 0;
  for (std::string_view rest = ptx; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    ++number;
    const std::string_view directive = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (in_debug_section) {
      in_debug_section = !directive.starts_with('}');
      continue;
    }
    if (directive.starts_with(".section")) {
      in_debug_section = true;
      continue;
    }
    if (directive.starts_with(".loc ") || directive.starts_with(".loc\t") || directive.starts_with(".file"))
      continue;
    if (lines.contains(number)) fmt::format_to(std::back_inserter(result), ".loc 1 {} 0\n", number);
    for (const char c : line)
      if (c != '\0') result += c;  // as drivers end the text
    result += '\n';
  }
  return result + ".file 1 \"kernel.ptx\"\n";
}

}  // namespace warpgrain::profiler::sass
