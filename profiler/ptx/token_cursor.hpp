#pragma once
// A place in a token list, with the refusals every part of the parser shares.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "profiler/ptx/lexer.hpp"

namespace warpgrain::profiler::ptx {

class TokenCursor {
 public:
  TokenCursor(const std::vector<Token>& tokens, std::string_view text, std::string_view where)
      : tokens_(tokens), text_(text), where_(where) {}

  const Token& peek(std::size_t ahead = 0) const {
    return tokens_[std::min(next_ + ahead, tokens_.size() - 1)];
  }
  bool at_end() const { return peek().kind == Token::Kind::end; }
  const Token& take();
  bool take_if(char punctuation);
  bool take_if_directive(std::string_view name);

  // These throw InputError at the present line when something else stands there.
  void expect(char punctuation);
  std::string expect_name(std::string_view what);
  std::uint64_t expect_integer(std::string_view what);
  std::string expect_string(std::string_view what);
  // An integer with an optional sign, in two's complement.
  std::uint64_t expect_signed_integer(std::string_view what);
  void skip_braces();  // from '{' to its '}'
  void skip_behind(char punctuation);

  // The text from `first` to the token before the present one, blanks and line breaks made single blanks.
  std::string text_since(const Token& first) const;
  [[noreturn]] void refuse(std::string_view what, std::string_view expected = {}) const;
  [[noreturn]] void refuse_at(std::uint32_t line, std::string_view what,
                              std::string_view expected = {}) const;
  [[noreturn]] void refuse_next(std::string_view expected) const;  // names the present token

 private:
  const std::vector<Token>& tokens_;
  std::string_view text_;
  std::string_view where_;
  std::size_t next_ = 0;
};

}  // namespace warpgrain::profiler::ptx
