// The arc tangent of doubles: of 1 / x where x is above one.

#include "profiler/builtins/polynomials.h"

WARPGRAIN_BUILTIN double atan(double x) {
  const double a = fabs(x);
  const double z = a > 1.0 ? 1.0 / a : a;
  const double square = z * z;
  const double p = z * square * warpgrain_atan_polynomial(square);
  const double angle = a > 1.0 ? 0x1.921fb54442d18p+0 - (z + (p - 0x1.1a62633145c07p-54)) : z + p;
  return copysign(angle, x);
}

WARPGRAIN_BUILTIN double atanpi(double x) { return atan(x) * M_1_PI; }

WARPGRAIN_VECTORS_X(atan, double)
WARPGRAIN_VECTORS_X(atanpi, double)
