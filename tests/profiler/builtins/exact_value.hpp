#pragma once
// Real numbers to 200 bits, and how far a float or a double is from one.

#include <cstddef>
#include <limits>
#include <mpfr.h>
#include <utility>

namespace warpgrain::profiler::builtins {

class Exact {
 public:
  Exact() { mpfr_init2(value_, 200); }
  explicit Exact(double value) : Exact() { mpfr_set_d(value_, value, MPFR_RNDN); }
  ~Exact() { mpfr_clear(value_); }
  Exact(const Exact&) = delete;
  Exact& operator=(const Exact&) = delete;

  mpfr_ptr get() { return value_; }
  mpfr_srcptr get() const { return value_; }

 private:
  mpfr_t value_;
};

// `exact` rounded once to T, to nearest even, subnormal numbers included.
template <class T>
T correctly_rounded(const Exact& exact);

// |got - exact| in units in the last place of T at `exact` (OpenCL 1.2, section 7.4), or in `least_unit`
// where that is larger. An infinity counts as the power of two behind the greatest finite number. Infinite
// where one is NaN and the other is not, where `exact` is infinite and `got` is not the same, and where both
// are zeros of different signs and `signed_zero` is asked for.
template <class T>
double ulp_error(const Exact& exact, T got, bool signed_zero, double least_unit = 0);

}  // namespace warpgrain::profiler::builtins
