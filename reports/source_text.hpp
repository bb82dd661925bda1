#pragma once
// The source of a kernel as a report carries it, and its lines under the names that compilers give them.

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace warpgrain::reports {

struct SourceText {
  std::string name;  // the file that lines are counted in until a #line directive says otherwise
  std::string text;
  std::string hash;      // text_hash(text)
  std::string compiler;  // version line
  std::string command;   // its options
};

// "fnv1a64:" and 16 hexadecimal digits: FNV-1a, 64 bits, over the bytes of the text. It tells versions of a
// source apart; it is no protection against forgery.
std::string text_hash(std::string_view text);

// A line of the text under the file and number that a compiler gives it, #line directives honoured.
struct SourceLine {
  std::string_view file;  // of `name` or of `text`: valid as long as they are
  std::uint32_t line = 0;
  std::string_view text;   // without the newline
  bool directive = false;  // the line is itself a #line directive, which belongs to no file
};

// Every line in order. Understands `#line N "file"`, `#line N` and the preprocessor's `# N "file" flags`.
std::vector<SourceLine> lines_of(std::string_view name, std::string_view text);

// Finds lines by file and number. The source must outlive it.
class SourceIndex {
 public:
  explicit SourceIndex(const SourceText& source);
  // Without blanks at its ends; empty when the source has no such line.
  std::string_view text_of(std::string_view file, std::uint32_t line) const;

 private:
  std::map<std::pair<std::string_view, std::uint32_t>, std::string_view> lines_;
};

}  // namespace warpgrain::reports
