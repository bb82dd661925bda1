#pragma once
// PTX text -> tokens. Comments are dropped; `.name` and `.name::name` are one token, so that an opcode is an
// identifier followed by directives.

#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace warpgrain::profiler::ptx {

struct Token {
  enum class Kind : std::uint8_t {
    identifier,   // letters, digits, _, $ and %: registers, labels, symbols, opcodes
    directive,    // `text` is without the leading dot
    integer,      // `value`
    float32,      // 0f........: `value` holds the bits
    float64,      // 0d................ or a decimal literal with a point: `value` holds the bits
    string,       // `text` is without the quotes
    punctuation,  // one character
    end
  };
  Kind kind = Kind::end;
  std::string_view text;
  std::uint64_t value = 0;
  std::uint32_t line = 0;  // from 1
  std::size_t begin = 0;   // offset of the first character in the module's text
  std::size_t finish = 0;  // offset behind the last one

  bool is(char c) const { return kind == Kind::punctuation && text.front() == c; }
  bool is_directive(std::string_view name) const { return kind == Kind::directive && text == name; }
};

// The last token is Kind::end. Tokens point into `text`. Throws InputError at `where`:line for a character or
// literal that PTX does not have.
std::vector<Token> tokenize(std::string_view text, std::string_view where);

}  // namespace warpgrain::profiler::ptx
