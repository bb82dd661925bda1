// Common and geometric functions (sections 6.12.4 and 6.12.5). OpenCL 1.2 gives most of them no limit; these
// are the ones of OpenCL's SPIR-V environment specification, for vectors of three.

#include <algorithm>
#include <cmath>

#include "tests/profiler/builtins/references.hpp"

namespace warpgrain::profiler::builtins {
namespace {

double epsilon(const Arguments& a) { return std::ldexp(1.0, 1 - a.digits); }
double largest(const Arguments& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
// No square overflows or is subnormal.
bool moderate(const Arguments& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z) && largest(a) < 1e18 &&
         std::min({std::abs(a.x), std::abs(a.y), std::abs(a.z)}) > 1e-17;
}
bool ordered(const Arguments& a) { return !std::isnan(a.x) && !std::isnan(a.y) && !std::isnan(a.z); }
bool limits_in_order(const Arguments& a) { return ordered(a) && a.y <= a.z; }
bool edges_in_order(const Arguments& a) { return moderate(a) && a.y < a.z; }
bool ratio(const Arguments& a) { return moderate(a) && a.z > 0 && a.z < 1; }

double clamp(const Arguments& a) { return std::clamp(a.x, a.y, a.z); }
double max(const Arguments& a) { return a.x < a.y ? a.y : a.x; }
double min(const Arguments& a) { return a.y < a.x ? a.y : a.x; }
double step(const Arguments& a) { return a.y < a.x ? 0 : 1; }
double sign(const Arguments& a) {
  if (std::isnan(a.x)) return 0;
  return a.x > 0 ? 1 : a.x < 0 ? -1 : a.x;
}

void times(mpfr_ptr result, const Arguments& a, bool inverse) {
  const Exact x(a.x);
  Exact factor;
  mpfr_const_pi(factor.get(), MPFR_RNDN);
  mpfr_div_ui(factor.get(), factor.get(), 180, MPFR_RNDN);
  if (inverse) mpfr_ui_div(factor.get(), 1, factor.get(), MPFR_RNDN);
  mpfr_mul(result, x.get(), factor.get(), MPFR_RNDN);
}
void radians(mpfr_ptr result, const Arguments& a) { times(result, a, false); }
void degrees(mpfr_ptr result, const Arguments& a) { times(result, a, true); }

void mix(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  mpfr_sub(result, y.get(), x.get(), MPFR_RNDN);
  mpfr_fma(result, result, z.get(), x.get(), MPFR_RNDN);
}
double error_of_mix(const Arguments& a) { return 4 * epsilon(a) * largest(a); }

// t = clamp((x - y) / (z - y), 0, 1), t^2 (3 - 2 t)
void smoothstep(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  Exact t, width;
  mpfr_sub(width.get(), z.get(), y.get(), MPFR_RNDN);
  mpfr_sub(t.get(), x.get(), y.get(), MPFR_RNDN);
  mpfr_div(t.get(), t.get(), width.get(), MPFR_RNDN);
  const Exact zero(0.0), one(1.0);
  mpfr_max(t.get(), t.get(), zero.get(), MPFR_RNDN);
  mpfr_min(t.get(), t.get(), one.get(), MPFR_RNDN);
  mpfr_mul_si(result, t.get(), -2, MPFR_RNDN);
  mpfr_add_ui(result, result, 3, MPFR_RNDN);
  mpfr_mul(result, result, t.get(), MPFR_RNDN);
  mpfr_mul(result, result, t.get(), MPFR_RNDN);
}
double error_of_smoothstep(const Arguments& a) { return 12 * epsilon(a); }

// (x, y, z) . (y, z, x)
void dot(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  mpfr_fmma(result, x.get(), y.get(), y.get(), z.get(), MPFR_RNDN);
  mpfr_fma(result, z.get(), x.get(), result, MPFR_RNDN);
}
double error_of_dot(const Arguments& a) { return largest(a) * largest(a) * 4 * epsilon(a); }

// The first component of (x, y, z) x (y, z, x)
void cross(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  mpfr_fmms(result, y.get(), x.get(), z.get(), z.get(), MPFR_RNDN);
}
double error_of_cross(const Arguments& a) { return largest(a) * largest(a) * 3 * epsilon(a); }

void norm(mpfr_ptr result, mpfr_srcptr x, mpfr_srcptr y, mpfr_srcptr z) {
  mpfr_fmma(result, x, x, y, y, MPFR_RNDN);
  mpfr_fma(result, z, z, result, MPFR_RNDN);
  mpfr_sqrt(result, result, MPFR_RNDN);
}
void length(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  norm(result, x.get(), y.get(), z.get());
}
// From (x, y, z) to (y, z, x).
void distance(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x), y(a.y), z(a.z);
  Exact p, q, r;
  mpfr_sub(p.get(), x.get(), y.get(), MPFR_RNDN);
  mpfr_sub(q.get(), y.get(), z.get(), MPFR_RNDN);
  mpfr_sub(r.get(), z.get(), x.get(), MPFR_RNDN);
  norm(result, p.get(), q.get(), r.get());
}
void normalize(mpfr_ptr result, const Arguments& a) {
  const Exact x(a.x);
  length(result, a);
  mpfr_div(result, x.get(), result, MPFR_RNDN);
}

const MathFunction common_table[] = {
    {"clamp",
     "clamp(x, y, z)",
     Inputs::xyz,
     exact,
     exact,
     exactly<clamp>,
     {.defined = limits_in_order, .signed_zero = false}},
    {"degrees", "degrees(x)", Inputs::x, 2, 2, degrees},
    {"max", "max(x, y)", Inputs::xy, exact, exact, exactly<max>, {.defined = ordered, .signed_zero = false}},
    {"min", "min(x, y)", Inputs::xy, exact, exact, exactly<min>, {.defined = ordered, .signed_zero = false}},
    {"mix",
     "mix(x, y, z)",
     Inputs::xyz,
     1,
     1,
     mix,
     {.defined = ratio, .absolute = error_of_mix, .limit_text = "ours: 4 max(\\|x\\|, \\|y\\|) epsilon"}},
    {"radians", "radians(x)", Inputs::x, 2, 2, radians},
    {"step", "step(x, y)", Inputs::xy, exact, exact, exactly<step>, {.defined = ordered}},
    {"smoothstep",
     "smoothstep(y, z, x)",
     Inputs::xyz,
     1,
     1,
     smoothstep,
     {.defined = edges_in_order, .absolute = error_of_smoothstep, .limit_text = "ours: 12 epsilon"}},
    {"sign", "sign(x)", Inputs::x, exact, exact, exactly<sign>},
    {"cross",
     "cross((T3)(x, y, z), (T3)(y, z, x)).x",
     Inputs::xyz,
     1,
     1,
     cross,
     {.defined = moderate,
      .absolute = error_of_cross,
      .signed_zero = false,
      .limit_text = "3 max^2 epsilon"}},
    {"dot",
     "dot((T3)(x, y, z), (T3)(y, z, x))",
     Inputs::xyz,
     1,
     1,
     dot,
     {.defined = moderate, .absolute = error_of_dot, .signed_zero = false, .limit_text = "4 max^2 epsilon"}},
    {"distance",
     "distance((T3)(x, y, z), (T3)(y, z, x))",
     Inputs::xyz,
     8.5,
     6,
     distance,
     {.defined = moderate}},
    {"length", "length((T3)(x, y, z))", Inputs::xyz, 4.25, 1.75, length},
    {"normalize", "normalize((T3)(x, y, z)).x", Inputs::xyz, 5, 4, normalize, {.defined = moderate}},
    {"fast_distance",
     "fast_distance((T3)(x, y, z), (T3)(y, z, x))",
     Inputs::xyz,
     8197.5,
     absent,
     distance,
     {.defined = moderate}},
    {"fast_length", "fast_length((T3)(x, y, z))", Inputs::xyz, 8194.5, absent, length, {.defined = moderate}},
    {"fast_normalize",
     "fast_normalize((T3)(x, y, z)).x",
     Inputs::xyz,
     8195,
     absent,
     normalize,
     {.defined = moderate}},
};

}  // namespace

std::span<const MathFunction> common_functions() { return common_table; }

}  // namespace warpgrain::profiler::builtins
