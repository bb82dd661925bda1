#include "cli/step_timing.hpp"

#include <algorithm>
#include <chrono>
#include <vector>

#include "analysis/statistics.hpp"

namespace warpgrain::cli {

double median_seconds_per_step(Simulation& simulation, std::uint64_t timed_steps) {
  using Clock = std::chrono::steady_clock;
  constexpr std::uint64_t readings = 5;
  const std::uint64_t steps = std::max<std::uint64_t>(1, timed_steps / readings);
  std::vector<double> seconds;
  for (std::uint64_t k = 0; k < readings; ++k) {
    const auto start = Clock::now();
    simulation.step(steps);
    seconds.push_back(std::chrono::duration<double>(Clock::now() - start).count() /
                      static_cast<double>(steps));
  }
  return median(seconds);
}

}  // namespace warpgrain::cli
