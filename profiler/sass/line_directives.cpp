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

bool is_debug_label(std::string_view line) {
  return line.starts_with("$L__tmp") || line.starts_with("$L__func_begin") ||
         line.starts_with("$L__func_end");
}

bool is_line_directive(std::string_view line) {
  return line.starts_with(".loc ") || line.starts_with(".loc\t") || line.starts_with(".file");
}

}  // namespace

AssemblerText assembler_text(std::string_view ptx) {
  const std::set<std::uint32_t> lines = statement_lines(ptx);
  AssemblerText result;
  bool in_debug_section = false;
  std::uint32_t number = 0;
  for (std::string_view rest = ptx; !rest.empty();) {
    const std::string_view line = rest.substr(0, rest.find('\n'));
    rest.remove_prefix(std::min(rest.size(), line.size() + 1));
    ++number;
    const std::string_view start = line.substr(std::min(line.find_first_not_of(" \t"), line.size()));
    if (start.starts_with(".section")) in_debug_section = true;
    if (in_debug_section) {
      in_debug_section = start.find('}') == std::string_view::npos;
      continue;
    }
    if (is_debug_label(start) || is_line_directive(start)) continue;
    if (lines.contains(number))
      fmt::format_to(std::back_inserter(result.with_lines), ".loc 1 {} 0\n", number);
    const std::size_t before = result.plain.size();
    for (const char c : line)
      if (c != '\0') result.plain += c;  // as drivers end the text
    result.plain += '\n';
    result.with_lines.append(result.plain, before);
  }
  result.with_lines += ".file 1 \"kernel.ptx\"\n";
  return result;
}

}  // namespace warpgrain::profiler::sass
