#pragma once
// One line of progress with rate and time left: on stderr, only when that is a terminal, never in a log.

#include <chrono>
#include <string>
#include <string_view>

namespace warpgrain::cli {

class Progress {
 public:
  explicit Progress(bool quiet);
  ~Progress();  // clears the line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // `fraction` in [0, 1]; `note` follows the bar ("12.3 M particle-steps/s"). Drawn at most ten times a
  // second.
  void update(std::string_view task, double fraction, std::string_view note = {});
  void clear();

 private:
  using Clock = std::chrono::steady_clock;
  bool shown_;
  bool drawn_ = false;
  std::string task_;
  Clock::time_point task_start_, last_draw_;
};

}  // namespace warpgrain::cli
