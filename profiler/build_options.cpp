#include "profiler/build_options.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::profiler {

std::vector<std::string> split_words(std::string_view options) {
  std::vector<std::string> words;
  std::string word;
  bool in_word = false;
  char quote = '\0';
  for (std::size_t i = 0; i < options.size(); ++i) {
    const char c = options[i];
    if (c == '\\' && i + 1 < options.size()) {
      word += options[++i];
      in_word = true;
    } else if (quote != '\0') {
      if (c == quote)
        quote = '\0';
      else
        word += c;
    } else if (c == '"' || c == '\'') {
      quote = c;
      in_word = true;
    } else if (!std::isspace(static_cast<unsigned char>(c))) {
      word += c;
      in_word = true;
    } else if (in_word) {
      words.push_back(std::move(word));
      word.clear();
      in_word = false;
    }
  }
  if (quote != '\0')
    throw_input_error("build options", fmt::format("'{}'", options), fmt::format("a closing {}", quote));
  if (in_word) words.push_back(std::move(word));
  return words;
}

std::vector<std::string> split_build_options(std::string_view options) {
  static constexpr std::array<std::string_view, 8> prefixes{"-D", "-I", "-U", "-cl-", "-W", "-O", "-g", "-w"};
  std::vector<std::string> words = split_words(options);
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const auto known = std::find_if(prefixes.begin(), prefixes.end(),
                                    [&](std::string_view p) { return word.starts_with(p); });
    if (known == prefixes.end()) throw_unknown_name("build options", "option", word, prefixes);
    // `-D NAME` and `-I DIR` in two words
    if (word.size() == 2 && (word == "-D" || word == "-I" || word == "-U")) {
      if (++i == words.size())
        throw_input_error("build options", fmt::format("'{}'", word), "a name behind it");
    }
  }
  return words;
}

}  // namespace warpgrain::profiler
