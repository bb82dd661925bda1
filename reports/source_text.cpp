#include "reports/source_text.hpp"

#include <charconv>
#include <fmt/format.h>
#include <optional>

namespace warpgrain::reports {
namespace {

std::string_view without_leading_blanks(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t");
  return start == std::string_view::npos ? std::string_view{} : text.substr(start);
}

struct LineDirective {
  std::uint32_t next_line = 0;
  std::optional<std::string_view> file;
};

std::optional<LineDirective> line_directive(std::string_view text) {
  text = without_leading_blanks(text);
  if (!text.starts_with('#')) return std::nullopt;
  text = without_leading_blanks(text.substr(1));
  if (text.starts_with("line")) text = without_leading_blanks(text.substr(4));
  LineDirective directive;
  const auto [rest, error] = std::from_chars(text.data(), text.data() + text.size(), directive.next_line);
  if (error != std::errc{}) return std::nullopt;  // #define, #if, ...
  text = without_leading_blanks(text.substr(static_cast<std::size_t>(rest - text.data())));
  if (text.starts_with('"'))
    if (const std::size_t end = text.find('"', 1); end != std::string_view::npos)
      directive.file = text.substr(1, end - 1);
  return directive;
}

}  // namespace

std::string text_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;  // the offset basis and prime of Fowler, Noll and Vo
  for (const char c : text) {
    hash ^= static_cast<unsigned char>(c);
    hash *= 0x100000001b3u;
  }
  return fmt::format("fnv1a64:{:016x}", hash);
}

std::vector<SourceLine> lines_of(std::string_view name, std::string_view text) {
  std::vector<SourceLine> lines;
  std::string_view file = name;
  std::uint32_t number = 1;
  while (!text.empty()) {
    const std::size_t end = text.find('\n');
    const std::string_view line = text.substr(0, end);
    text = end == std::string_view::npos ? std::string_view{} : text.substr(end + 1);
    if (const auto directive = line_directive(line)) {
      if (directive->file) file = *directive->file;
      lines.push_back({file, 0, line, true});
      number = directive->next_line;
    } else {
      lines.push_back({file, number++, line, false});
    }
  }
  return lines;
}

SourceIndex::SourceIndex(const SourceText& source) {
  for (const SourceLine& line : lines_of(source.name, source.text))
    if (!line.directive) lines_[{line.file, line.line}] = line.text;
}

std::string_view SourceIndex::text_of(std::string_view file, std::uint32_t line) const {
  const auto found = lines_.find({file, line});
  if (found == lines_.end()) return {};
  const std::string_view text = without_leading_blanks(found->second);
  return text.substr(0, text.find_last_not_of(" \t\r") + 1);
}

}  // namespace warpgrain::reports
