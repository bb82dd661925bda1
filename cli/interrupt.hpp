#pragma once
// Ctrl-C in commands that can stop half way: the first asks them to end and keep what they have, a second one
// ends the program where it stands. In all other commands it ends the program, as it does where nobody
// watches.

#include <cstddef>
#include <string>
#include <string_view>

namespace warpgrain::cli {

// What a shell says of a program that SIGINT has ended.
inline constexpr int interrupted_status = 130;

// Thrown where there is nothing yet to keep; run_app answers with interrupted_status.
struct Interrupted {};

// Watches SIGINT and SIGTERM while it lives. One at a time.
class InterruptWatch {
 public:
  InterruptWatch();
  ~InterruptWatch();
  InterruptWatch(const InterruptWatch&) = delete;
  InterruptWatch& operator=(const InterruptWatch&) = delete;
};

// A line on stderr: what of the command is done, and how to do the rest where it is kept (`kept`: a file or
// folder); interrupted_status.
int say_interrupted(std::string_view command, std::size_t n_done, const std::string& kept);

// Whether one has come since the watch began; never without a watch.
bool interrupted();

}  // namespace warpgrain::cli
