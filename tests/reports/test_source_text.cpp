#include <gtest/gtest.h>

#include "reports/source_text.hpp"

namespace warpgrain::reports {
namespace {

TEST(SourceText, HashIsFnv1a64) {
  // Test vectors of the authors: http://www.isthe.com/chongo/src/fnv/test_fnv.c
  EXPECT_EQ(text_hash(""), "fnv1a64:cbf29ce484222325");
  EXPECT_EQ(text_hash("a"), "fnv1a64:af63dc4c8601ec8c");
  EXPECT_EQ(text_hash("foobar"), "fnv1a64:85944171f73967e8");
}

TEST(SourceText, LinesFollowLineDirectives) {
  const std::string text = "a\n#line 7 \"x.cl\"\nb\nc\n# 3 \"y.h\" 1\nd\n#line 9\n#define E 1\n";
  const auto lines = lines_of("main.cl", text);
  ASSERT_EQ(lines.size(), 8u);
  EXPECT_EQ(lines[0].file, "main.cl");
  EXPECT_EQ(lines[0].line, 1u);
  EXPECT_TRUE(lines[1].directive);
  EXPECT_EQ(lines[2].file, "x.cl");
  EXPECT_EQ(lines[2].line, 7u);
  EXPECT_EQ(lines[3].line, 8u);
  EXPECT_EQ(lines[5].file, "y.h");
  EXPECT_EQ(lines[5].line, 3u);
  EXPECT_EQ(lines[7].file, "y.h") << "a directive without a file keeps it";
  EXPECT_EQ(lines[7].line, 9u);
  EXPECT_EQ(lines[7].text, "#define E 1");
}

TEST(SourceText, IndexFindsTrimmedLines) {
  const SourceText source{
      .name = "k.cl", .text = "one\n\t two \r\n", .hash = {}, .compiler = {}, .command = {}};
  const SourceIndex index(source);
  EXPECT_EQ(index.text_of("k.cl", 2), "two");
  EXPECT_EQ(index.text_of("k.cl", 3), "");
  EXPECT_EQ(index.text_of("other.cl", 1), "");
}

}  // namespace
}  // namespace warpgrain::reports
