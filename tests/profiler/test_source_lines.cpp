#include <gtest/gtest.h>

#include "profiler/source_lines.hpp"

namespace warpgrain::profiler {
namespace {

TEST(SourceLines, LabelsComeFromTheMarkElseFromTheLine) {
  const SourceLines lines("kernel void k() {\n  if (a) b();  // branch: is it touching \n\tif (c) d();\r\n}");
  EXPECT_EQ(lines.label("k.cl", 2), "is it touching");
  EXPECT_EQ(lines.label("k.cl", 3), "if (c) d();");
  EXPECT_EQ(lines.label("k.cl", 4), "}");
  EXPECT_EQ(lines.label("k.cl", 5), "");
  EXPECT_EQ(lines.label("k.cl", 0), "");
}

TEST(SourceLines, LineDirectivesAreObeyed) {
  const SourceLines lines(
      "main 1\n#line 10 \"a.h\"\na 10\na 11\n  # 5 \"b.h\" 1\nb 5\n#line 20\nb 20\n#define X\nb 22\n");
  EXPECT_EQ(lines.label("k.cl", 1), "main 1");
  EXPECT_EQ(lines.label("a.h", 10), "a 10");
  EXPECT_EQ(lines.label("a.h", 11), "a 11");
  EXPECT_EQ(lines.label("a.h", 1), "");
  EXPECT_EQ(lines.label("b.h", 5), "b 5");
  EXPECT_EQ(lines.label("b.h", 20), "b 20");
  EXPECT_EQ(lines.label("b.h", 22), "b 22");
}

TEST(SourceLines, OtherFilesGetNoLabelsOfTheMainFile) {
  const SourceLines lines("main 1\n#line 1 \"a.h\"\na 1\n#line 9 \"k.cl\"\nmain 9\n", "k.cl");
  EXPECT_EQ(lines.label("k.cl", 1), "main 1");
  EXPECT_EQ(lines.label("k.cl", 9), "main 9");
  EXPECT_EQ(lines.label("a.h", 1), "a 1");
  EXPECT_EQ(lines.label("elsewhere.h", 1), "");
}

TEST(SourceLines, NoSourceNoLabel) { EXPECT_EQ(SourceLines("").label("k.cl", 1), ""); }

}  // namespace
}  // namespace warpgrain::profiler
