#include "run_python.hpp"

#include <cstdio>
#include <gtest/gtest.h>

#include "tests/paths.hpp"

namespace warpgrain::reports {

std::vector<std::string> run_python(const std::string& script,
                                    const std::vector<std::filesystem::path>& files) {
  std::string command = "/usr/bin/python3 " + source_path("tests/reports/") + script;
  for (const auto& file : files) {
    command += " '";
    command += file.string();
    command += '\'';
  }
  FILE* output = popen(command.c_str(), "r");
  if (output == nullptr) {
    ADD_FAILURE() << "cannot run " << command;
    return {};
  }
  std::vector<std::string> lines(1);
  for (int c = std::fgetc(output); c != EOF; c = std::fgetc(output))
    if (c == '\n')
      lines.emplace_back();
    else
      lines.back() += static_cast<char>(c);
  EXPECT_EQ(pclose(output), 0) << command;
  lines.pop_back();
  return lines;
}

}  // namespace warpgrain::reports
