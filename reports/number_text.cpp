#include "reports/number_text.hpp"

#include <array>
#include <cmath>
#include <fmt/format.h>

namespace warpgrain::reports {

std::string count_text(std::uint64_t count) {
  const std::string digits = fmt::format("{}", count);
  std::string text;
  for (std::size_t k = 0; k < digits.size(); ++k) {
    if (k > 0 && (digits.size() - k) % 3 == 0) text += ',';
    text += digits[k];
  }
  return text;
}

std::string percent_text(double part, double whole) {
  return part == 0 || whole == 0 ? "0 %" : fmt::format("{:.1f} %", 100 * part / whole);
}

std::string fixed_text(double value, int decimals) { return fmt::format("{:.{}f}", value, decimals); }

std::string seconds_text(double seconds) {
  struct Unit {
    double seconds;
    const char* name;
  };
  constexpr std::array<Unit, 4> units{{{1, "s"}, {1e-3, "ms"}, {1e-6, "us"}, {1e-9, "ns"}}};
  if (seconds == 0) return "0 s";
  const Unit* unit = &units.front();
  while (unit != &units.back() && std::abs(seconds) < 0.9995 * unit->seconds)
    ++unit;  // 0.9995 prints as 1.00
  return fmt::format("{:#.3g} {}", seconds / unit->seconds, unit->name);
}

}  // namespace warpgrain::reports
