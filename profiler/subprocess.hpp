#pragma once
// Programs that are run, and the files they work on.

#include <filesystem>
#include <string>
#include <vector>

namespace warpgrain::profiler {

// A folder of its own that goes with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

struct ProcessResult {
  int exit_status = 0;  // 128 + signal when one ended it
  std::string output;   // stdout
  std::string errors;   // stderr
};

// Runs a program to its end, without a shell. Where this process handles SIGINT, a Ctrl-C in the terminal
// does not reach the program. Throws std::system_error when it cannot be started.
ProcessResult run_process(const std::vector<std::string>& arguments);

// The file of that name in the folders of PATH; empty when there is none.
std::filesystem::path find_program(const std::string& name);

std::string read_text(const std::filesystem::path& path);
void write_text(const std::filesystem::path& path, std::string_view text);

}  // namespace warpgrain::profiler
