#pragma once
// The one way to refuse an input. Every place that reads something a user wrote throws InputError; the
// command line prints its single line and exits with 2.

#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace warpgrain {

// An input that cannot be used: "<where>: <what>; expected <expected>". Holds one line, never more, except
// when it carries another program's message (a kernel compiler's), which follows on lines of its own.
class InputError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// A simulation that was told to go on and cannot: a particle left the domain, its contact slots are full, a
// NaN appeared. Also exit 2, because it is the scene that cannot be carried.
class SimulationError : public InputError {
 public:
  using InputError::InputError;
};

// Throws InputError. `where` is a file, or file and field or line; `what` is what stands there, quoted;
// `expected` is what was expected there (left out when empty).
[[noreturn]] void throw_input_error(std::string_view where, std::string_view what,
                                    std::string_view expected = {});

// Throws SimulationError in the same form; `where` names the particle.
[[noreturn]] void throw_simulation_error(std::string_view where, std::string_view what,
                                         std::string_view expected = {});

// Throws InputError for a name that is not in a list, and prints the list: "--contact: unknown value 'x';
// valid: a, b".
[[noreturn]] void throw_unknown_name(std::string_view where, std::string_view kind, std::string_view name,
                                     std::span<const std::string_view> valid);

}  // namespace warpgrain
