#include "profiler/launch_file.hpp"

#include <charconv>
#include <fmt/format.h>
#include <fstream>
#include <limits>

#include "core/error.hpp"

namespace warpgrain::profiler {
namespace {

constexpr std::string_view blanks = " \t\r\v\f";

struct Token {
  std::string text;
  int line = 0;
};

// The words of a launch file, comments left out; a header `<...>` is one word.
class Tokens {
 public:
  explicit Tokens(const std::filesystem::path& path) : path_(path.string()) {
    std::ifstream in(path);
    if (!in) throw_input_error(path_, "cannot be read", "a launch file");
    std::string line;
    for (line_ = 1; std::getline(in, line); ++line_) split(std::string_view(line).substr(0, line.find('#')));
  }

  std::string where(int line) const { return fmt::format("{}:{}", path_, line); }
  bool at_end() const { return next_ == tokens_.size(); }
  const Token& peek() const { return tokens_[next_]; }
  const Token& take(std::string_view what) {
    if (at_end()) throw_input_error(where(line_), "the file ends", what);
    return tokens_[next_++];
  }

  template <typename T>
  T take_size(std::string_view what) {
    const Token& token = take(what);
    T value = 0;
    const char* const end = token.text.data() + token.text.size();
    const auto result = std::from_chars(token.text.data(), end, value);
    if (result.ec != std::errc{} || result.ptr != end || value == 0)
      throw_input_error(where(token.line), fmt::format("'{}'", token.text), what);
    return value;
  }

 private:
  void split(std::string_view text) {
    for (;;) {
      const std::size_t begin = text.find_first_not_of(blanks);
      if (begin == std::string_view::npos) return;
      text.remove_prefix(begin);
      std::size_t end = std::min(text.find_first_of(" \t\r\v\f<", 1), text.size());
      if (text.front() == '<') {
        end = text.find('>') + 1;
        if (end == 0)
          throw_input_error(where(line_), fmt::format("'{}'", text), "a '>' that ends the argument");
      }
      tokens_.push_back({std::string(text.substr(0, end)), line_});
      text.remove_prefix(end);
    }
  }

  std::string path_;
  std::vector<Token> tokens_;
  std::size_t next_ = 0;
  int line_ = 0;
};

// The words between < and >.
class HeaderReader {
 public:
  HeaderReader(const Token& header, const std::filesystem::path& folder, std::string where)
      : folder_(folder), where_(std::move(where)) {
    argument_.line = header.line;
    std::string_view words = std::string_view(header.text).substr(1, header.text.size() - 2);
    for (;;) {
      const std::size_t begin = words.find_first_not_of(blanks);
      if (begin == std::string_view::npos) break;
      words.remove_prefix(begin);
      const std::string_view word = words.substr(0, words.find_first_of(blanks));
      words.remove_prefix(word.size());
      take(word);
    }
    check();
  }

  LaunchFileArgument argument() && { return std::move(argument_); }

 private:
  [[noreturn]] void refuse(std::string_view what, std::string_view expected) const {
    throw_input_error(where_, what, expected);
  }

  void take(std::string_view word) {
    LaunchFileArgument& a = argument_;
    const std::size_t equals = word.find('=');
    const std::string_view name = word.substr(0, equals);
    if (equals != std::string_view::npos) {
      take_value(word, name, word.substr(equals + 1));
    } else if (name == "dump") {
      a.dump = true;
    } else if (name == "hex") {
      a.hex = true;
    } else if (name == "null") {
      a.is_null = true;
    } else if (name == "noinit") {
      a.no_init = true;
    } else if (name == "ro") {
      a.read_only = true;
    } else if (name == "wo") {
      a.write_only = true;
    } else if (const auto type = element_type_of(name)) {
      if (a.type) refuse(fmt::format("a second type, '{}'", name), "one");
      a.type = type;
    } else {
      refuse_unknown(word);
    }
  }

  void take_value(std::string_view word, std::string_view name, std::string_view value) {
    LaunchFileArgument& a = argument_;
    if (value.empty()) refuse(fmt::format("'{}'", word), fmt::format("a value behind '{}'", word));
    if (name == "size") {
      const char* const end = value.data() + value.size();
      const auto result = std::from_chars(value.data(), end, a.size);
      if (result.ec != std::errc{} || result.ptr != end || a.size == 0)
        refuse(fmt::format("'{}'", word), "a number of bytes above 0");
    } else if (name == "fill") {
      a.fill = value;
    } else if (name == "range") {
      a.range = value;
    } else if (name == "file") {
      a.file = folder_ / value;
    } else {
      refuse_unknown(word);
    }
  }

  [[noreturn]] void refuse_unknown(std::string_view word) const {
    refuse(fmt::format("unknown word '{}'", word),
           fmt::format("size=, fill=, range=, file=, hex, noinit, null, ro, wo, dump, or a type ({})",
                       fmt::join(element_names(), ", ")));
  }

  void check() const {
    const LaunchFileArgument& a = argument_;
    const int n_sources = !a.fill.empty() + !a.range.empty() + !a.file.empty() + a.no_init;
    if (a.is_null && (a.size != 0 || n_sources != 0 || a.dump))
      refuse("'null' beside size, data or dump", "'null' with at most a type, hex, ro or wo");
    if (!a.is_null && a.size == 0) refuse("an argument without a size", "size=BYTES");
    if (n_sources > 1) refuse("several sources of data", "one of fill=, range=, file= and noinit");
    if (a.read_only && a.write_only) refuse("'ro' and 'wo'", "one of them");
  }

  const std::filesystem::path& folder_;
  std::string where_;
  LaunchFileArgument argument_;
};

LaunchFileArgument take_argument(Tokens& tokens, const std::filesystem::path& folder) {
  const Token header = tokens.take("an argument");
  const std::string where = tokens.where(header.line);
  if (header.text.front() != '<')
    throw_input_error(where, fmt::format("'{}'", header.text),
                      "an argument, <size=...>, or the end of the file");
  LaunchFileArgument argument = HeaderReader(header, folder, where).argument();
  const bool has_values = !argument.is_null && !argument.no_init && argument.fill.empty() &&
                          argument.range.empty() && argument.file.empty();
  while (has_values && !tokens.at_end() && tokens.peek().text.front() != '<') {
    const Token& value = tokens.take("a value");
    argument.values.push_back({value.text, value.line});
  }
  return argument;
}

}  // namespace

LaunchFile read_launch_file(const std::filesystem::path& path) {
  Tokens tokens(path);
  LaunchFile file;
  file.path = path;
  const std::string program = tokens.take("the program's file name").text;
  file.program = path.parent_path() / program;
  if (!std::filesystem::exists(file.program) && std::filesystem::exists(program)) file.program = program;
  if (std::ifstream options(options_file(file.program)); options) std::getline(options, file.build_options);
  file.kernel = tokens.take("the kernel's name").text;
  for (std::uint64_t& size : file.shape.global_size)
    size = tokens.take_size<std::uint64_t>("a global size, three numbers above 0");
  for (std::uint32_t& size : file.shape.local_size)
    size = tokens.take_size<std::uint32_t>("a local size, three numbers above 0");
  while (!tokens.at_end()) file.arguments.push_back(take_argument(tokens, path.parent_path()));
  return file;
}

}  // namespace warpgrain::profiler
