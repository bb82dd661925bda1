#include "profiler/ptx/token_cursor.hpp"

#include <cctype>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {

const Token& TokenCursor::take() {
  const Token& token = peek();
  if (!at_end()) ++next_;
  return token;
}

bool TokenCursor::take_if(char punctuation) {
  if (!peek().is(punctuation)) return false;
  take();
  return true;
}

bool TokenCursor::take_if_directive(std::string_view name) {
  if (!peek().is_directive(name)) return false;
  take();
  return true;
}

void TokenCursor::expect(char punctuation) {
  if (!take_if(punctuation)) refuse_next(fmt::format("'{}'", punctuation));
}

std::string TokenCursor::expect_name(std::string_view what) {
  if (peek().kind != Token::Kind::identifier) refuse_next(what);
  return std::string(take().text);
}

std::uint64_t TokenCursor::expect_integer(std::string_view what) {
  if (peek().kind != Token::Kind::integer) refuse_next(what);
  return take().value;
}

std::string TokenCursor::expect_string(std::string_view what) {
  if (peek().kind != Token::Kind::string) refuse_next(what);
  return std::string(take().text);
}

std::uint64_t TokenCursor::expect_signed_integer(std::string_view what) {
  const bool minus = take_if('-');
  const std::uint64_t magnitude = expect_integer(what);
  return minus ? ~magnitude + 1 : magnitude;
}

void TokenCursor::skip_behind(char punctuation) {
  while (!take_if(punctuation)) {
    if (at_end()) refuse_next(fmt::format("'{}'", punctuation));
    take();
  }
}

void TokenCursor::skip_braces() {
  const std::uint32_t opened = peek().line;
  expect('{');
  for (int depth = 1; depth > 0;) {
    if (at_end()) refuse_at(opened, "'{' opens here", "its end, '}'");
    const Token& token = take();
    if (token.is('{')) ++depth;
    if (token.is('}')) --depth;
  }
}

std::string TokenCursor::text_since(const Token& first) const {
  const std::size_t finish = next_ > 0 ? tokens_[next_ - 1].finish : first.finish;
  std::string text;
  for (const char c : text_.substr(first.begin, finish - first.begin)) {
    const bool blank = std::isspace(static_cast<unsigned char>(c)) != 0;
    if (!blank)
      text += c;
    else if (!text.empty() && text.back() != ' ')
      text += ' ';
  }
  return text;
}

void TokenCursor::refuse(std::string_view what, std::string_view expected) const {
  refuse_at(peek().line, what, expected);
}

void TokenCursor::refuse_at(std::uint32_t line, std::string_view what, std::string_view expected) const {
  throw_input_error(place(where_, line), what, expected);
}

void TokenCursor::refuse_next(std::string_view expected) const {
  const Token& token = peek();
  refuse(at_end() ? std::string("end of the text")
                  : fmt::format("'{}{}'", token.kind == Token::Kind::directive ? "." : "", token.text),
         expected);
}

}  // namespace warpgrain::profiler::ptx
