#include "cli/help_text.hpp"

#include <sstream>
#include <stdexcept>

namespace warpgrain::cli {

extern const char help_markdown[];

namespace {

// "| `--steps` | Run this many |" -> {"--steps", "Run this many"}; empty when the line is no option's row.
std::pair<std::string, std::string> parse_row(const std::string& line) {
  if (line.rfind("| `", 0) != 0) return {};
  const auto end_of_name = line.find("` | ", 3);
  const auto end = line.rfind(" |");
  if (end_of_name == std::string::npos || end == std::string::npos || end < end_of_name + 4) return {};
  return {line.substr(3, end_of_name - 3), line.substr(end_of_name + 4, end - end_of_name - 4)};
}

}  // namespace

HelpText::HelpText(std::string_view markdown) {
  std::istringstream in{std::string(markdown)};
  Section* section = nullptr;
  bool in_summary = false;
  for (std::string line; std::getline(in, line);) {
    if (line.rfind("## ", 0) == 0) {
      section = &sections_[line.substr(3)];
      in_summary = true;
    } else if (!section) {
      continue;
    } else if (const auto [name, meaning] = parse_row(line); !name.empty()) {
      section->options[name] = meaning;
    } else if (line.empty()) {
      in_summary = in_summary && section->summary.empty();
    } else if (in_summary) {
      section->summary += (section->summary.empty() ? "" : " ") + line;
    }
  }
}

const std::string& HelpText::summary(std::string_view command) const {
  const auto found = sections_.find(command);
  if (found == sections_.end()) throw std::logic_error("docs/cli.md has no section " + std::string(command));
  return found->second.summary;
}

const std::string& HelpText::option(std::string_view command, std::string_view option) const {
  for (std::string_view name : {command, std::string_view("common")}) {
    const auto section = sections_.find(name);
    if (section == sections_.end()) continue;
    const auto found = section->second.options.find(option);
    if (found != section->second.options.end()) return found->second;
  }
  throw std::logic_error("docs/cli.md: " + std::string(command) + " has no option " + std::string(option));
}

const HelpText& help_text() {
  static const HelpText text{help_markdown};
  return text;
}

}  // namespace warpgrain::cli
