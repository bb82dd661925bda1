#include "profiler/ptx/lexer.hpp"

#include <bit>
#include <cctype>
#include <charconv>
#include <fmt/format.h>
#include <string>

#include "core/error.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {
namespace {

bool starts_name(char c) {
  return std::isalpha(static_cast<unsigned char>(c)) || c == '_' || c == '$' || c == '%';
}
bool continues_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '$'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

class Lexer {
 public:
  Lexer(std::string_view text, std::string_view where) : text_(text), where_(where) {}

  std::vector<Token> run() {
    for (skip_blank(); position_ < text_.size(); skip_blank()) tokens_.push_back(next());
    Token end;
    end.line = line_;
    end.begin = end.finish = position_;
    tokens_.push_back(end);
    return std::move(tokens_);
  }

 private:
  char peek(std::size_t ahead = 0) const {
    return position_ + ahead < text_.size() ? text_[position_ + ahead] : '\0';
  }

  [[noreturn]] void refuse(std::string_view what, std::string_view expected) const {
    throw_input_error(place(where_, line_), what, expected);
  }

  void skip_blank() {
    while (position_ < text_.size()) {
      if (peek() == '\n') {
        ++line_;
        ++position_;
      } else if (std::isspace(static_cast<unsigned char>(peek()))) {
        ++position_;
      } else if (peek() == '/' && peek(1) == '/') {
        position_ = std::min(text_.find('\n', position_), text_.size());
      } else if (peek() == '/' && peek(1) == '*') {
        skip_block_comment();
      } else {
        return;
      }
    }
  }

  void skip_block_comment() {
    const std::size_t close = text_.find("*/", position_ + 2);
    if (close == std::string_view::npos) refuse("a comment opens here", "its end, '*/'");
    for (; position_ < close + 2; ++position_)
      if (peek() == '\n') ++line_;
  }

  Token next() {
    Token token;
    token.line = line_;
    token.begin = position_;
    if (starts_name(peek())) {
      token.kind = Token::Kind::identifier;
      ++position_;
      take_name();
    } else if (peek() == '.' && continues_name(peek(1))) {  // .2d begins with a digit
      token.kind = Token::Kind::directive;
      ++position_;
      take_directive();
    } else if (is_digit(peek())) {
      take_number(token);
    } else if (peek() == '"') {
      token.kind = Token::Kind::string;
      const std::size_t close = text_.find_first_of("\"\n", position_ + 1);
      if (close == std::string_view::npos || text_[close] == '\n')
        refuse("a string opens here", "its end, '\"'");
      position_ = close + 1;
    } else if (std::string_view("()[]{}<>,;:=+-!@|*").find(peek()) != std::string_view::npos) {
      token.kind = Token::Kind::punctuation;
      ++position_;
    } else {
      refuse(fmt::format("character '{}'", std::isprint(static_cast<unsigned char>(peek())) ? peek() : '?'),
             "PTX");
    }
    token.finish = position_;
    token.text = text_.substr(token.begin, token.finish - token.begin);
    if (token.kind == Token::Kind::directive) token.text.remove_prefix(1);
    if (token.kind == Token::Kind::string) token.text = token.text.substr(1, token.text.size() - 2);
    return token;
  }

  void take_name() {
    while (continues_name(peek())) ++position_;
  }

  void take_directive() {
    take_name();
    while (peek() == ':' && peek(1) == ':' && continues_name(peek(2))) {
      position_ += 2;
      take_name();
    }
  }

  // 0x, 0b, octal and decimal integers with an optional U; 0f and 0d floats in hexadecimal; decimals with a
  // point.
  void take_number(Token& token) {
    const char second = static_cast<char>(std::tolower(static_cast<unsigned char>(peek(1))));
    token.kind = Token::Kind::integer;
    if (peek() == '0' && second == 'f') {
      token.kind = Token::Kind::float32;
      token.value = take_digits(2, 16, 8);
    } else if (peek() == '0' && second == 'd') {
      token.kind = Token::Kind::float64;
      token.value = take_digits(2, 16, 16);
    } else if (peek() == '0' && second == 'x') {
      token.value = take_digits(2, 16, 0);
    } else if (peek() == '0' && second == 'b') {
      token.value = take_digits(2, 2, 0);
    } else if (const std::size_t size = decimal_fraction(); size > 0) {
      double value = 0;
      std::from_chars(text_.data() + position_, text_.data() + position_ + size, value);
      token.kind = Token::Kind::float64;
      token.value = std::bit_cast<std::uint64_t>(value);
      position_ += size;
    } else {
      token.value = take_digits(0, peek() == '0' && is_digit(second) ? 8 : 10, 0);
    }
    if (token.kind == Token::Kind::integer && peek() == 'U') ++position_;
    if (continues_name(peek()))
      refuse(fmt::format("'{}'", text_.substr(token.begin, position_ + 1 - token.begin)), "a number");
  }

  // Characters of a decimal literal such as 1.5 or 2.0e-3 at the present place; 0 when there is no such
  // literal.
  std::size_t decimal_fraction() const {
    std::size_t i = 0;
    while (is_digit(peek(i))) ++i;
    if (peek(i) != '.' || !is_digit(peek(i + 1))) return 0;
    for (++i; is_digit(peek(i));) ++i;
    if (peek(i) == 'e' || peek(i) == 'E') {
      std::size_t exponent = i + 1;
      if (peek(exponent) == '+' || peek(exponent) == '-') ++exponent;
      if (is_digit(peek(exponent)))
        for (i = exponent; is_digit(peek(i));) ++i;
    }
    return i;
  }

  // Reads digits behind a prefix of `skip` characters; exactly `count` of them unless 0.
  std::uint64_t take_digits(std::size_t skip, int base, std::size_t count) {
    const char* const first = text_.data() + position_ + skip;
    const char* const last =
        count ? std::min(first + count, text_.data() + text_.size()) : text_.data() + text_.size();
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(first, last, value, base);
    const auto taken = static_cast<std::size_t>(end - first);
    if (error != std::errc{} || (count && taken != count)) {
      refuse(fmt::format("'{}'", text_.substr(position_, skip + taken + 1)),
             count ? fmt::format("{} hexadecimal digits", count) : "a number that fits 64 bits");
    }
    position_ += skip + taken;
    return value;
  }

  std::string_view text_;
  std::string_view where_;
  std::size_t position_ = 0;
  std::uint32_t line_ = 1;
  std::vector<Token> tokens_;
};

}  // namespace

std::vector<Token> tokenize(std::string_view text, std::string_view where) {
  return Lexer(text, where).run();
}

}  // namespace warpgrain::profiler::ptx
