// erf and erfc. Above one: (1 + 2 x) exp(x^2) erfc(x) is smooth in (x - 4) / (x + 4) (M. M. Shepherd and
// J. G. Laframboise, Mathematics of Computation 36, 1981). exp(-x^2) is the square of exp(-x^2 / 2), which is
// never subnormal, and what x^2 loses in rounding is put back.

#include "profiler/builtins/polynomials.h"

#define WARPGRAIN_ERROR_FUNCTIONS(T, largest)                                                             \
  /* For x from 1 on. */                                                                                  \
  WARPGRAIN_INLINE T warpgrain_tail(T x) {                                                                \
    const T square = x * x, lost = fma(x, x, -square);                                                    \
    const T root = exp((T)-0.5 * square);                                                                 \
    const T p = warpgrain_erfc_polynomial((x - (T)4.0) / (x + (T)4.0));                                   \
    return (root * (p * ((T)1.0 - lost) / ((T)1.0 + (T)2.0 * x))) * root;                                 \
  }                                                                                                       \
  WARPGRAIN_BUILTIN T erf(T x) {                                                                          \
    const T a = fabs(x);                                                                                  \
    if (a < (T)1.0) return fma(x, warpgrain_erf_polynomial(x * x), x);                                    \
    return a < (T)largest ? copysign((T)1.0 - warpgrain_tail(a), x) : isnan(x) ? x : copysign((T)1.0, x); \
  }                                                                                                       \
  WARPGRAIN_BUILTIN T erfc(T x) {                                                                         \
    const T a = fabs(x);                                                                                  \
    if (a < (T)0.5) return (T)1.0 - erf(x);                                                               \
    if (a < (T)largest) {                                                                                 \
      const T tail = warpgrain_tail(a);                                                                   \
      return x < (T)0.0 ? (T)2.0 - tail : tail;                                                           \
    }                                                                                                     \
    return isnan(x) ? x : x < (T)0.0 ? (T)2.0 : (T)0.0;                                                   \
  }                                                                                                       \
  WARPGRAIN_VECTORS_X(erf, T)                                                                             \
  WARPGRAIN_VECTORS_X(erfc, T)

// Where erfc has vanished.
WARPGRAIN_ERROR_FUNCTIONS(float, 10.1)
WARPGRAIN_ERROR_FUNCTIONS(double, 27.3)
