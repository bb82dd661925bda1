#pragma once
// The texts of docs/cli.md, by command and option: `--help` and the page cannot part.

#include <map>
#include <string>
#include <string_view>

namespace warpgrain::cli {

class HelpText {
 public:
  // Parses the page: a "## name" heading opens a command, its first paragraph is the summary, and rows
  // "| `option` | meaning |" are its options.
  explicit HelpText(std::string_view markdown);

  const std::string& summary(std::string_view command) const;
  // Falls back on the section "common". Throws std::logic_error for an option that the page does not have.
  const std::string& option(std::string_view command, std::string_view option) const;

  using Options = std::map<std::string, std::string, std::less<>>;
  struct Section {
    std::string summary;
    Options options;
  };
  const std::map<std::string, Section, std::less<>>& sections() const { return sections_; }

 private:
  std::map<std::string, Section, std::less<>> sections_;
};

// The page that was compiled in.
const HelpText& help_text();

}  // namespace warpgrain::cli
