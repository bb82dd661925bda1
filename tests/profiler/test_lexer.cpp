#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "profiler/ptx/lexer.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using Kind = Token::Kind;
using testing::HasSubstr;

TEST(Lexer, TokensOfAnInstruction) {
  const auto tokens =
      tokenize("@!%p1 ld.global.L1::no_allocate.f32 \t%f1, [%rd2+-4]; // comment\n$L__BB0_1:", "x.ptx");
  std::vector<std::string_view> texts;
  for (const Token& token : tokens) texts.push_back(token.text);
  EXPECT_THAT(texts, testing::ElementsAre("@", "!", "%p1", "ld", "global", "L1::no_allocate", "f32", "%f1",
                                          ",", "[", "%rd2", "+", "-", "4", "]", ";", "$L__BB0_1", ":", ""));
  EXPECT_TRUE(tokens[4].is_directive("global"));
  EXPECT_EQ(tokens[15].line, 1u);
  EXPECT_EQ(tokens[16].line, 2u);
  EXPECT_EQ(tokens.back().kind, Kind::end);
}

TEST(Lexer, Numbers) {
  const auto tokens = tokenize("10 0x1F 017 0b101 7U 0f3F800000 0d3FF0000000000000 1.5 2.5e-1 0", "x.ptx");
  const std::vector<std::uint64_t> values{
      10, 31, 15, 5, 7, 0x3F800000, 0x3FF0000000000000, 0x3FF8000000000000, 0x3FD0000000000000, 0};
  const std::vector<Kind> kinds{Kind::integer, Kind::integer, Kind::integer, Kind::integer, Kind::integer,
                                Kind::float32, Kind::float64, Kind::float64, Kind::float64, Kind::integer};
  ASSERT_EQ(tokens.size(), values.size() + 1);
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_EQ(tokens[i].value, values[i]) << tokens[i].text;
    EXPECT_EQ(tokens[i].kind, kinds[i]) << tokens[i].text;
  }
}

TEST(Lexer, CommentsAndStrings) {
  const auto tokens = tokenize("a /* two\nlines */ b \"a // string\" c", "x.ptx");
  ASSERT_EQ(tokens.size(), 5u);
  EXPECT_EQ(tokens[1].line, 2u);
  EXPECT_EQ(tokens[2].kind, Kind::string);
  EXPECT_EQ(tokens[2].text, "a // string");
}

TEST(Lexer, RefusesByPlace) {
  const auto refused = [](std::string_view text) { return refusal([&] { tokenize(text, "x.ptx"); }); };
  EXPECT_EQ(refused("a\nb ?"), "x.ptx, PTX line 2: character '?'; expected PTX");
  EXPECT_THAT(refused("/* open"), HasSubstr("x.ptx, PTX line 1: a comment opens here"));
  EXPECT_THAT(refused("\"open\n\""), HasSubstr("x.ptx, PTX line 1: a string opens here"));
  EXPECT_THAT(refused("0f12"), HasSubstr("8 hexadecimal digits"));
  EXPECT_THAT(refused("0f"), HasSubstr("8 hexadecimal digits"));
  EXPECT_THAT(refused("99999999999999999999999"), HasSubstr("a number that fits 64 bits"));
  EXPECT_THAT(refused("12abc"), HasSubstr("a number"));
  EXPECT_THAT(refused(std::string_view("\x01", 1)), HasSubstr("character '?'"));
}

}  // namespace
}  // namespace warpgrain::profiler::ptx
