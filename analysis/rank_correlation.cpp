#include "analysis/rank_correlation.hpp"

#include <cmath>
#include <fmt/format.h>
#include <random>

#include "analysis/statistics.hpp"
#include "core/error.hpp"

namespace warpgrain {
namespace {

constexpr int n_draws = 1000;

int sign(double difference) { return (difference > 0) - (difference < 0); }

void require_same_length(std::size_t a, std::size_t b) {
  if (a != b) throw_input_error("rank correlation", fmt::format("{} and {} values", a, b), "as many of both");
}

}  // namespace

std::optional<double> kendall_tau(std::span<const double> a, std::span<const double> b) {
  require_same_length(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k)
    if (std::isnan(a[k]) || std::isnan(b[k]))
      throw_input_error(fmt::format("value {}", k), "NaN", "a number");
  double balance = 0, ordered_by_a = 0, ordered_by_b = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const int in_a = sign(a[i] - a[j]), in_b = sign(b[i] - b[j]);
      balance += in_a * in_b;
      ordered_by_a += in_a != 0;
      ordered_by_b += in_b != 0;
    }
  if (ordered_by_a == 0 || ordered_by_b == 0) return std::nullopt;
  return balance / std::sqrt(ordered_by_a * ordered_by_b);
}

std::optional<TauInterval> kendall_interval(std::span<const double> predicted,
                                            std::span<const std::vector<double>> readings,
                                            std::uint64_t seed) {
  require_same_length(predicted.size(), readings.size());
  for (std::size_t k = 0; k < readings.size(); ++k)
    if (readings[k].empty()) throw_input_error(fmt::format("value {}", k), "no reading", "one or more");
  std::mt19937_64 random(seed);
  std::vector<double> taus, drawn(readings.size());
  for (int draw = 0; draw < n_draws; ++draw) {
    for (std::size_t k = 0; k < readings.size(); ++k) drawn[k] = readings[k][random() % readings[k].size()];
    const auto tau = kendall_tau(predicted, drawn);
    if (!tau) return std::nullopt;
    taus.push_back(*tau);
  }
  return TauInterval{percentile(taus, 2.5), percentile(taus, 97.5)};
}

}  // namespace warpgrain
