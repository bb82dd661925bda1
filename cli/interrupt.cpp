#include "cli/interrupt.hpp"

#include <fmt/format.h>
#include <iostream>

namespace warpgrain::cli {
namespace {

volatile std::sig_atomic_t has_come = 0;

void note_interrupt(int) { has_come = 1; }

}  // namespace

InterruptWatch::InterruptWatch(std::initializer_list<int> signals) {
  has_come = 0;
  struct sigaction action = {};
  action.sa_handler = note_interrupt;
  // The next one meets the default; calls that wait for a file or a child go on.
  action.sa_flags = static_cast<int>(SA_RESETHAND) | SA_RESTART;
  for (const int signal : signals) sigaction(signal, &action, &before_.emplace_back(signal, action).second);
}

InterruptWatch::~InterruptWatch() {
  for (const auto& [signal, action] : before_) sigaction(signal, &action, nullptr);
  has_come = 0;
}

int say_interrupted(std::string_view command, std::string_view how_far, const std::string& kept) {
  std::cerr << fmt::format("warpgrain {}: interrupted {}{}\n", command, how_far,
                           kept.empty() || kept == "-" ? "" : "; the same call with --resume does the rest");
  return interrupted_status;
}

bool interrupted() { return has_come != 0; }

}  // namespace warpgrain::cli
