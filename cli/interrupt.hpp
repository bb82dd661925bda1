#pragma once
// Ctrl-C in commands that can stop half way: the first asks them to end and keep what they have, a second one
// ends the program where it stands. In all other commands it ends the program, as it does where nobody
// watches.

#include <csignal>
#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace warpgrain::cli {

// What a shell says of a program that SIGINT has ended.
inline constexpr int interrupted_status = 130;

// Thrown where there is nothing yet to keep; run_app answers with interrupted_status.
struct Interrupted {};

// Watches these signals while it lives. One at a time.
class InterruptWatch {
 public:
  explicit InterruptWatch(std::initializer_list<int> signals = {SIGINT, SIGTERM});
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;

 private:
  std::vector<std::pair<int, struct sigaction>> before_;
};

// A line on stderr: how far the command came ("after 3 of its cases"), and how to do the rest where that is
// kept (`kept`: a file or folder); interrupted_status.
int say_interrupted(std::string_view command, std::string_view how_far, const std::string& kept);

// Whether one has come since the watch began; never without a watch.
bool interrupted();

}  // namespace warpgrain::cli
