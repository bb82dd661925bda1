#include "analysis/limit_search.hpp"

#include <cmath>
#include <fmt/format.h>
#include <map>

#include "core/error.hpp"

namespace warpgrain {
namespace {

void require_range(const SearchRange& range) {
  const auto usable = [](double end) { return std::isfinite(end) && end > 0; };
  if (!usable(range.from) || !usable(range.to) || range.from == range.to || range.samples < 2)
    throw_input_error("limit search",
                      fmt::format("{} samples from {} to {}", range.samples, range.from, range.to),
                      "two samples or more between two different numbers above 0");
}

double between(double a, double b, double share) {
  if (share == 0) return a;
  if (share == 1) return b;
  return std::exp(std::lerp(std::log(a), std::log(b), share));
}

}  // namespace

std::vector<Limit> find_limits(const std::function<double(double)>& error, const SearchRange& range,
                               std::span<const double> bounds) {
  require_range(range);
  std::map<double, double> known;
  const auto keeps = [&](double x, double bound) {
    const auto found = known.find(x);
    const double value = found != known.end() ? found->second : known.emplace(x, error(x)).first->second;
    return value <= bound;
  };
  std::vector<double> samples;
  for (int k = 0; k < range.samples; ++k)
    samples.push_back(between(range.from, range.to, static_cast<double>(k) / (range.samples - 1)));

  std::vector<Limit> limits;
  for (const double bound : bounds) {
    keeps(samples.front(), bound);
    keeps(samples.back(), bound);
    std::size_t first = 0;
    while (first < samples.size() && keeps(samples[first], bound)) ++first;
    Limit limit;
    if (first > 0) limit.until = samples[first - 1];
    if (first < samples.size()) limit.beyond = samples[first];
    for (int k = 0; k < range.halvings && limit.until && limit.beyond; ++k) {
      const double middle = between(*limit.until, *limit.beyond, 0.5);
      (keeps(middle, bound) ? limit.until : limit.beyond) = middle;
    }
    limits.push_back(limit);
  }
  return limits;
}

}  // namespace warpgrain
