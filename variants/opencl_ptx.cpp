#include "variants/opencl_ptx.hpp"

#include <algorithm>
#include <regex>

namespace warpgrain {
namespace {

// PTX begins with .version, before which only comments and blanks stand.
bool is_ptx(std::string_view text) {
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(text.size(), line.size() + 1));
    const std::string_view start = line.substr(std::min(line.find_first_not_of(" \t\r"), line.size()));
    if (!start.empty() && !start.starts_with("//")) return start.starts_with(".version");
  }
  return false;
}

}  // namespace

std::optional<std::string> ptx_of_binary(std::string_view binary) {
  std::string text(binary);
  std::erase(text, '\0');
  if (!is_ptx(text)) return std::nullopt;
  return std::regex_replace(text, std::regex(R"(%envreg\d+)"), "0");
}

}  // namespace warpgrain
