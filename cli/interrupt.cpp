#include "cli/interrupt.hpp"

#include <array>
#include <csignal>
#include <cstddef>
#include <fmt/format.h>
#include <iostream>

namespace warpgrain::cli {
namespace {

constexpr std::array<int, 2> watched_signals{SIGINT, SIGTERM};
volatile std::sig_atomic_t has_come = 0;
std::array<struct sigaction, watched_signals.size()> actions_before;

void note_interrupt(int) { has_come = 1; }

}  // namespace

InterruptWatch::InterruptWatch() {
  has_come = 0;
  struct sigaction action = {};
  action.sa_handler = note_interrupt;
  // The next one meets the default; calls that wait for a file or a child go on.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (std::size_t k = 0; k < watched_signals.size(); ++k)
    sigaction(watched_signals[k], &action, &actions_before[k]);
}

InterruptWatch::~InterruptWatch() {
  for (std::size_t k = 0; k < watched_signals.size(); ++k)
    sigaction(watched_signals[k], &actions_before[k], nullptr);
  has_come = 0;
}

int say_interrupted(std::string_view command, std::size_t n_done, const std::string& kept) {
  std::cerr << fmt::format(
      "warpgrain {}: interrupted after {} of its cases{}\n", command, n_done,
      kept.empty() || kept == "-" ? "" : "; the same call with --resume does the others");
  return interrupted_status;
}

bool interrupted() { return has_come != 0; }

}  // namespace warpgrain::cli
