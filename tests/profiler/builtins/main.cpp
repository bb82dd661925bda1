// The tests; with --write-page FILE the page of what they measure instead.

#include <fstream>
#include <gtest/gtest.h>
#include <iostream>
#include <string_view>

#include "tests/profiler/builtins/documentation.hpp"

int main(int count, char** arguments) {
  if (count == 3 && std::string_view(arguments[1]) == "--write-page") {
    std::ofstream out(arguments[2]);
    out << warpgrain::profiler::builtins::page();
    out.close();
    if (out) return 0;
    std::cerr << arguments[2] << ": cannot be written\n";
    return 2;
  }
  testing::InitGoogleTest(&count, arguments);
  return RUN_ALL_TESTS();
}
