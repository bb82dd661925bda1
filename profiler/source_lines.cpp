#include "profiler/source_lines.hpp"

#include <charconv>
#include <optional>

namespace warpgrain::profiler {
namespace {

constexpr std::string_view blanks = " \t\r";
constexpr std::string_view branch_mark = "// branch:";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(blanks);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(blanks) - first + 1);
}

struct LineDirective {
  std::uint32_t line = 0;
  std::optional<std::string_view> file;
};

// `#line 12 "FILE"`, `#line 12`, and `# 12 "FILE"` as preprocessors write it.
std::optional<LineDirective> line_directive(std::string_view text) {
  text = trimmed(text);
  if (!text.starts_with('#')) return std::nullopt;
  text = trimmed(text.substr(1));
  if (text.starts_with("line")) text = trimmed(text.substr(4));
  LineDirective directive;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), directive.line);
  if (error != std::errc{}) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  const std::size_t open = text.find('"'), close = text.rfind('"');
  if (open != close) directive.file = text.substr(open + 1, close - open - 1);
  return directive;
}

}  // namespace

SourceLines::SourceLines(std::string_view source, std::string_view name) : name_(name) {
  std::string file;  // empty: the main file
  std::uint32_t line = 1;
  while (!source.empty()) {
    const std::size_t end = std::min(source.find('\n'), source.size());
    const std::string_view text = source.substr(0, end);
    source.remove_prefix(std::min(end + 1, source.size()));
    if (const auto directive = line_directive(text)) {
      line = directive->line;
      if (directive->file) file = *directive->file == name_ ? std::string() : std::string(*directive->file);
      if (!file.empty()) named_.insert(file);
      continue;
    }
    lines_.insert_or_assign({file, line++}, std::string(trimmed(text)));
  }
}

std::string SourceLines::label(std::string_view file, std::uint32_t line) const {
  std::string key(file);
  if (!named_.contains(key)) {
    if (!name_.empty() && file != name_) return {};
    key.clear();
  }
  const auto found = lines_.find({key, line});
  if (found == lines_.end()) return {};
  const std::string& text = found->second;
  const std::size_t mark = text.rfind(branch_mark);
  return mark == std::string::npos
             ? text
             : std::string(trimmed(std::string_view(text).substr(mark + branch_mark.size())));
}

}  // namespace warpgrain::profiler
