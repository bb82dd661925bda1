#pragma once
// The folder that launches are recorded in: launch files, programs, bytes of buffers, and the index of all.
// Several processes may share one.

#include <atomic>
#include <cstddef>
#include <cstdint>
#include <fstream>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "cli/layer/programs.hpp"
#include "cli/record_settings.hpp"
#include "profiler/launch_file.hpp"

namespace warpgrain::layer {

// Thread safe. Functions throw InputError when something cannot be written.
class LaunchFolder {
 public:
  // `memory`: bytes that buffers may take.
  LaunchFolder(std::filesystem::path folder, std::uint64_t memory);

  // Whether so many bytes may still be added.
  bool has_room_for(std::uint64_t bytes) const { return bytes <= memory_ - std::min(memory_, used_.load()); }
  // A buffer of these bytes. Equal contents take room once.
  profiler::LaunchFileArgument add_buffer(std::span<const std::byte> bytes);
  // Its source and options, once; the file's name in the folder.
  std::string add_program(const std::shared_ptr<const ProgramText>& program);
  // Under the next free number. The file's path is set here.
  void add_launch(profiler::LaunchFile file, const std::string& remark);
  // What was not recorded, and why.
  void add_unrecorded(const std::string& kernel, const std::string& why);

 private:
  std::string claim(const std::string& stem, const std::string& extension, int& number);
  void append_to_index(const std::string& line);

  const std::filesystem::path folder_;
  const std::uint64_t memory_;
  std::atomic<std::uint64_t> used_ = 0;
  std::mutex mutex_;
  int next_program_ = 1, next_launch_ = 1;
  std::vector<std::pair<std::shared_ptr<const ProgramText>, std::string>> programs_;  // with their files
};

}  // namespace warpgrain::layer
