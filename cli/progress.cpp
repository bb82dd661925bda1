#include "cli/progress.hpp"

#include <algorithm>
#include <cstdio>
#include <fmt/format.h>
#include <unistd.h>

namespace warpgrain::cli {

Progress::Progress(bool quiet) : shown_(!quiet && isatty(STDERR_FILENO)) {}

Progress::~Progress() { clear(); }

void Progress::update(std::string_view task, double fraction, std::string_view note) {
  if (!shown_) return;
  const auto now = Clock::now();
  if (task != task_) {
    task_ = task;
    task_start_ = now;
  } else if (now - last_draw_ < std::chrono::milliseconds(100) && fraction < 1) {
    return;
  }
  last_draw_ = now;
  const double elapsed = std::chrono::duration<double>(now - task_start_).count();
  fraction = std::clamp(fraction, 0.0, 1.0);
  std::string left;
  if (fraction > 0.02 && elapsed > 1)
    left = fmt::format(", {:.0f} s left", elapsed * (1 - fraction) / fraction);
  fmt::print(stderr, "\r\033[K{} {:3.0f} %{}{}{}", task_, 100 * fraction, left, note.empty() ? "" : ", ",
             note);
  std::fflush(stderr);
  drawn_ = true;
}

void Progress::clear() {
  if (drawn_) fmt::print(stderr, "\r\033[K");
  drawn_ = false;
}

}  // namespace warpgrain::cli
