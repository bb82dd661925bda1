// Sine, cosine and tangent.

#include "profiler/builtins/angle_reduction.h"

WARPGRAIN_INLINE float warpgrain_sine_of_rest(float r) {
  const float square = r * r;
  return fma(r * square, warpgrain_sin_polynomial(square), r);
}

WARPGRAIN_INLINE float warpgrain_cosine_of_rest(float r) {
  const float square = r * r;
  return fma(square, fma(square, warpgrain_cos_polynomial(square), -0.5f), 1.0f);
}

WARPGRAIN_INLINE double warpgrain_sine_of_rest(double r, double low) {
  const double square = r * r;
  return r + fma(r * square, warpgrain_sin_polynomial(square), low * fma(square, -0.5, 1.0));
}

WARPGRAIN_INLINE double warpgrain_cosine_of_rest(double r, double low) {
  const double square = r * r, half_square = 0.5 * square, most = 1.0 - half_square;
  return most +
         fma(square * square, warpgrain_cos_polynomial(square), ((1.0 - most) - half_square) - r * low);
}

// sin(n pi / 2 + r)
WARPGRAIN_INLINE float warpgrain_sine_of_quadrant(int n, float r) {
  const float value = (n & 1) ? warpgrain_cosine_of_rest(r) : warpgrain_sine_of_rest(r);
  return (n & 2) ? -value : value;
}

WARPGRAIN_INLINE double warpgrain_sine_of_quadrant(int n, double r, double low) {
  const double value = (n & 1) ? warpgrain_cosine_of_rest(r, low) : warpgrain_sine_of_rest(r, low);
  return (n & 2) ? -value : value;
}

WARPGRAIN_INLINE float warpgrain_sincos(float x, float* cosine) {
  float r;
  const int n = warpgrain_reduce_angle(x, &r);
  *cosine = warpgrain_sine_of_quadrant(n + 1, r);
  return x == 0.0f ? x : warpgrain_sine_of_quadrant(n, r);
}

WARPGRAIN_INLINE double warpgrain_sincos(double x, double* cosine) {
  double r, low;
  const int n = warpgrain_reduce_angle(x, &r, &low);
  *cosine = warpgrain_sine_of_quadrant(n + 1, r, low);
  return x == 0.0 ? x : warpgrain_sine_of_quadrant(n, r, low);
}

WARPGRAIN_BUILTIN float sin(float x) {
  float r;
  const int n = warpgrain_reduce_angle(x, &r);
  return x == 0.0f ? x : warpgrain_sine_of_quadrant(n, r);
}

WARPGRAIN_BUILTIN float cos(float x) {
  float r;
  const int n = warpgrain_reduce_angle(x, &r);
  return warpgrain_sine_of_quadrant(n + 1, r);
}

WARPGRAIN_BUILTIN float tan(float x) {
  float r;
  const int n = warpgrain_reduce_angle(x, &r);
  const float square = r * r;
  const float tangent = fma(r * square, warpgrain_tan_polynomial(square), r);
  if (x == 0.0f) return x;
  return (n & 1) ? -1.0f / tangent : tangent;
}

WARPGRAIN_BUILTIN double sin(double x) {
  double r, low;
  const int n = warpgrain_reduce_angle(x, &r, &low);
  return x == 0.0 ? x : warpgrain_sine_of_quadrant(n, r, low);
}

WARPGRAIN_BUILTIN double cos(double x) {
  double r, low;
  const int n = warpgrain_reduce_angle(x, &r, &low);
  return warpgrain_sine_of_quadrant(n + 1, r, low);
}

WARPGRAIN_BUILTIN double tan(double x) {
  double r, low;
  const int n = warpgrain_reduce_angle(x, &r, &low);
  const double square = r * r;
  const double tangent = r + fma(r * square, warpgrain_tan_polynomial(square), low * (1.0 + square));
  if (x == 0.0) return x;
  return (n & 1) ? -1.0 / tangent : tangent;
}

WARPGRAIN_BUILTIN float half_sin(float x) { return sin(x); }
WARPGRAIN_BUILTIN float half_cos(float x) { return cos(x); }
WARPGRAIN_BUILTIN float half_tan(float x) { return tan(x); }

WARPGRAIN_VECTORS_X(sin, float)
WARPGRAIN_VECTORS_X(cos, float)
WARPGRAIN_VECTORS_X(tan, float)
WARPGRAIN_VECTORS_X(sin, double)
WARPGRAIN_VECTORS_X(cos, double)
WARPGRAIN_VECTORS_X(tan, double)
WARPGRAIN_VECTORS_X(half_sin, float)
WARPGRAIN_VECTORS_X(half_cos, float)
WARPGRAIN_VECTORS_X(half_tan, float)
WARPGRAIN_SECONDS_OF_X(sincos, warpgrain_sincos, float, float)
WARPGRAIN_SECONDS_OF_X(sincos, warpgrain_sincos, double, double)
