// The gamma function and its logarithm. Up to 8 or 10 the recurrence gamma(x + 1) = x gamma(x) leads to the
// neighbourhood of 2, above there is Stirling's series, below zero the reflection gamma(x) gamma(-x) = -pi /
// (x sin(pi x)) (M. Abramowitz and I. A. Stegun, Handbook of Mathematical Functions, 6.1.15-6.1.17
// and 6.1.37-6.1.41).

#include "profiler/builtins/polynomials.h"

#define WARPGRAIN_GAMMA_FUNCTIONS(T, largest, smallest)                                                 \
  /* x in (1/2, 10) is 2 + t times a product: gamma(x) = gamma(2 + t) product, t from -1/2 to 1/2. */   \
  WARPGRAIN_INLINE T warpgrain_towards_two(T x, T* t) {                                                 \
    T product = (T)1.0;                                                                                 \
    *t = x - (T)2.0;                                                                                    \
    if (x < (T)1.5) {                                                                                   \
      *t = x - (T)1.0;                                                                                  \
      return (T)1.0 / x;                                                                                \
    }                                                                                                   \
    while (x > (T)2.5) {                                                                                \
      x -= (T)1.0;                                                                                      \
      product *= x;                                                                                     \
    }                                                                                                   \
    *t = x - (T)2.0;                                                                                    \
    return product;                                                                                     \
  }                                                                                                     \
                                                                                                        \
  /* The absolute value is what this returns. */                                                        \
  WARPGRAIN_INLINE T warpgrain_log_gamma(T x, int* sign) {                                              \
    const T a = fabs(x);                                                                                \
    *sign = signbit(x) ? -1 : 1;                                                                        \
    if (isnan(x) || isinf(x)) {                                                                         \
      *sign = 1;                                                                                        \
      return a;                                                                                         \
    }                                                                                                   \
    if (a < (T)0.5) {                                                                                   \
      /* gamma(2 + x) = (1 + x) x gamma(x) */                                                           \
      return x * warpgrain_log_gamma_polynomial(x) - log1p(x) - log(a);                                 \
    }                                                                                                   \
    if (x < (T)0.0) {                                                                                   \
      if (floor(x) == x) {                                                                              \
        *sign = 1;                                                                                      \
        return (T)INFINITY;                                                                             \
      }                                                                                                 \
      const T half_floor = (T)0.5 * floor(x);                                                           \
      *sign = floor(half_floor) == half_floor ? 1 : -1;                                                 \
    }                                                                                                   \
    T result;                                                                                           \
    if (a < (T)1.5) {                                                                                   \
      const T t = a - (T)1.0;                                                                           \
      result = t * warpgrain_log_gamma_polynomial(t) - log1p(t);                                        \
    } else if (a < (T)8.0) {                                                                            \
      T t;                                                                                              \
      const T product = warpgrain_towards_two(a, &t);                                                   \
      result = fma(t, warpgrain_log_gamma_polynomial(t), log(product));                                 \
    } else {                                                                                            \
      const T inverse = (T)1.0 / a;                                                                     \
      const T rest = fma(inverse, warpgrain_log_stirling_polynomial(inverse), (T)0x1.acfe390c97d69p-2); \
      result = fma(a - (T)0.5, log(a) - (T)1.0, rest);                                                  \
    }                                                                                                   \
    if (x > (T)0.0) return result;                                                                      \
    return log((T)M_PI / (a * fabs(sinpi(a)))) - result;                                                \
  }                                                                                                     \
                                                                                                        \
  WARPGRAIN_BUILTIN T lgamma(T x) {                                                                     \
    int sign;                                                                                           \
    return warpgrain_log_gamma(x, &sign);                                                               \
  }                                                                                                     \
                                                                                                        \
  WARPGRAIN_BUILTIN T tgamma(T x) {                                                                     \
    const T a = fabs(x);                                                                                \
    if (a < (T)0.5) return exp(x * warpgrain_log_gamma_polynomial(x)) / ((T)1.0 + x) / x;               \
    if (isnan(x) || (x < (T)0.0 && floor(x) == x)) return (T)NAN;                                       \
    if (x > (T)largest) return (T)INFINITY;                                                             \
    const T half_floor = (T)0.5 * floor(x);                                                             \
    if (x < (T)smallest) return floor(half_floor) == half_floor ? (T)0.0 : (T)-0.0;                     \
    T first, second;                                                                                    \
    if (a < (T)10.0) {                                                                                  \
      T t;                                                                                              \
      second = warpgrain_towards_two(a, &t);                                                            \
      first = exp(t * warpgrain_log_gamma_polynomial(t));                                               \
    } else {                                                                                            \
      /* Half the power, twice: the whole overflows before e^-x brings it back. */                      \
      second = pow(a, (T)0.5 * (a - (T)0.5));                                                           \
      first = (T)0x1.40d931ff62706p+1 * warpgrain_stirling_polynomial((T)1.0 / a) * (second * exp(-a)); \
    }                                                                                                   \
    if (x > (T)0.0) return first * second;                                                              \
    return -(T)M_PI / (a * sinpi(a) * first) / second;                                                  \
  }                                                                                                     \
                                                                                                        \
  WARPGRAIN_VECTORS_X(lgamma, T)                                                                        \
  WARPGRAIN_VECTORS_X(tgamma, T)                                                                        \
  WARPGRAIN_SECONDS_OF_X(lgamma_r, warpgrain_log_gamma, T, int)

// From where on gamma is infinite, and below where it has vanished.
WARPGRAIN_GAMMA_FUNCTIONS(float, 35.1, -46.0)
WARPGRAIN_GAMMA_FUNCTIONS(double, 171.7, -185.0)
