#pragma once
// How far a parameter can go before something stops being right: a few samples over the range, then
// bisection, both in log space.

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace warpgrain {

struct SearchRange {
  double from = 0, to = 0;  // above 0, either may be the larger; the search goes from `from` to `to`
  int samples = 5;          // spread over the range, both ends among them; at least 2
  int halvings = 8;         // of the interval between two samples, in log space
};

// Where the error first exceeds a bound. `until` is the last value known to keep it (none: not even `from`
// does), `beyond` the first known to exceed it (none: the whole range keeps it, as far as samples tell).
struct Limit {
  std::optional<double> until, beyond;
};

// One limit a bound, [bounds]. `error` is asked once for a value, `to` being asked right after `from`; what
// is NaN exceeds every bound. Throws InputError for a range that is none.
std::vector<Limit> find_limits(const std::function<double(double)>& error, const SearchRange& range,
                               std::span<const double> bounds);

}  // namespace warpgrain
