#pragma once
// Finds source lines by the file and line that a compiler gave them, `#line` directives obeyed.

#include <cstdint>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace warpgrain::profiler {

class SourceLines {
 public:
  // `name` is what the compiler calls the main file, to which lines belong that no `#line` gave to another
  // one. Empty: any file that no `#line` names is taken for it.
  explicit SourceLines(std::string_view source, std::string_view name = {});

  // The name of a branch that stands there: NAME of a `// branch: NAME` that ends the line, else the line's
  // text without the blanks around it. Empty when there is no such line.
  std::string label(std::string_view file, std::uint32_t line) const;

 private:
  std::string name_;
  std::set<std::string> named_;                                         // files that #line names
  std::map<std::pair<std::string, std::uint32_t>, std::string> lines_;  // main file: ""
};

}  // namespace warpgrain::profiler
