#pragma once
// In which order the threads of a launch fill its warps.

#include <cstdint>
#include <string>
#include <string_view>

namespace warpgrain::profiler {

struct ThreadOrder {
  enum class Kind : std::uint8_t {
    launched,  // as they are
    shuffled,  // at random
    sorted     // by a count of each thread, smallest first, equal ones as launched
  };
  Kind kind = Kind::launched;
  std::uint64_t seed = 1;                   // of `shuffled`
  std::string key = "thread_instructions";  // of `sorted`; thread_key.hpp says which there are

  // "launched", "shuffled:1" or "sorted:thread_instructions".
  std::string name() const;
  // Reads a name; seed and key may be left out. InputError with the valid forms; `where` names the option.
  static ThreadOrder from_name(std::string_view name, std::string_view where);
  bool operator==(const ThreadOrder&) const = default;
};

}  // namespace warpgrain::profiler
