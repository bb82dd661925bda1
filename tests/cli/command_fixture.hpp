#pragma once
// Runs `warpgrain` in this process, in a folder of its own, and keeps what it printed.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <gtest/gtest.h>
#include <iterator>
#include <string>
#include <vector>

#include "cli/app.hpp"
#include "tests/temporary_folder.hpp"

namespace warpgrain::cli {

class CommandTest : public testing::Test {
 protected:
  int call(std::vector<std::string> words) {
    words.insert(words.begin(), "warpgrain");
    std::vector<const char*> argv;
    for (const std::string& word : words) argv.push_back(word.c_str());
    testing::internal::CaptureStdout();
    testing::internal::CaptureStderr();
    const int status = run_app(static_cast<int>(argv.size()), argv.data());
    out_ = testing::internal::GetCapturedStdout();
    err_ = testing::internal::GetCapturedStderr();
    return status;
  }

  std::string path(const std::string& name) const { return (folder_ / name).string(); }

  std::string write(const std::string& name, const std::string& text) const {
    std::filesystem::create_directories((folder_ / name).parent_path());
    std::ofstream(folder_ / name) << text;
    return path(name);
  }

  std::string read(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  std::size_t error_lines() const {
    return static_cast<std::size_t>(std::count(err_.begin(), err_.end(), '\n'));
  }

  TemporaryFolder folder_;
  std::string out_, err_;
};

}  // namespace warpgrain::cli
