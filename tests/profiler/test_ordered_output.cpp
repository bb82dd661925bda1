#include <gtest/gtest.h>
#include <sstream>
#include <thread>
#include <vector>

#include "profiler/ordered_output.hpp"

namespace warpgrain::profiler {
namespace {

TEST(OrderedOutput, PiecesWaitForThoseBeforeThem) {
  std::ostringstream out;
  OrderedOutput ordered(out);
  ordered.write(1, "b");
  ordered.write(3, "d");
  EXPECT_EQ(out.str(), "");
  ordered.write(0, "a");
  EXPECT_EQ(out.str(), "ab");
  ordered.write(2, "");
  EXPECT_EQ(out.str(), "abd");
}

TEST(OrderedOutput, ThreadsMayBringThem) {
  std::ostringstream out;
  OrderedOutput ordered(out);
  {
    std::vector<std::jthread> threads;
    for (int t = 0; t < 4; ++t)
      threads.emplace_back([&ordered, t] {
        for (int i = t; i < 400; i += 4)
          ordered.write(static_cast<std::uint64_t>(i), std::to_string(i) + " ");
      });
  }
  std::string expected;
  for (int i = 0; i < 400; ++i) expected += std::to_string(i) + " ";
  EXPECT_EQ(out.str(), expected);
}

}  // namespace
}  // namespace warpgrain::profiler
