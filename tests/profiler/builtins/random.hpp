#pragma once
// Random numbers that are the same on every machine.

#include <cstdint>
#include <random>

namespace warpgrain::profiler::builtins {

constexpr std::uint64_t seed = 20120315;

// std::mt19937_64 is defined to the last bit; the standard distributions are not.
class Random {
 public:
  explicit Random(std::uint64_t start = seed) : engine_(start) {}
  std::uint64_t bits() { return engine_(); }
  std::uint64_t below(std::uint64_t count) { return bits() % count; }
  double between(double from, double to) {
    return from + (to - from) * static_cast<double>(bits() >> 11) * 0x1p-53;
  }

 private:
  std::mt19937_64 engine_;
};

}  // namespace warpgrain::profiler::builtins
