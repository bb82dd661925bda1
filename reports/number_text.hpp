#pragma once
// Numbers for people. Documents for programs hold them in full (json_text.hpp).

#include <cstdint>
#include <string>

namespace warpgrain::reports {

std::string count_text(std::uint64_t count);          // 12,345,678
std::string percent_text(double part, double whole);  // "62.1 %"; "0 %" of nothing
std::string fixed_text(double value, int decimals);   // 0.235
std::string seconds_text(double seconds);             // "1.23 ms", three digits and a unit from ns to s

}  // namespace warpgrain::reports
