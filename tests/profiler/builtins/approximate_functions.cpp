// half_ functions: 8192 ULP, angles up to 2^16. native_ functions: OpenCL leaves them to the implementation;
// the bounds here are those of the instructions that they become in NVIDIA's PTX ISA, section 9.7.3:
// sin, cos 2^-20.5 absolute within 2 pi; ex2 2 ULP; lg2 2^-22 absolute in (0.5, 2), relative elsewhere; rcp 1
// ULP; sqrt 2^-23 and rsqrt 2^-22.9 relative; div.approx 2 ULP for divisors in [2^-126, 2^126].

#include <cmath>

#include "tests/profiler/builtins/references.hpp"

namespace warpgrain::profiler::builtins {
namespace {

bool half_angle(const Arguments& a) { return std::abs(a.x) <= 65536; }
bool native_angle(const Arguments& a) { return std::abs(a.x) <= 2 * M_PI; }
bool native_tangent(const Arguments& a) { return std::abs(a.x) <= 1; }
double error_of_angle(const Arguments&) { return std::exp2(-20.5); }
double error_of_tangent(const Arguments&) { return std::exp2(-18); }
double error_of_log(const Arguments& a) { return a.x > 0.5 && a.x < 2 ? std::exp2(-22) : 0; }
bool divisor(const Arguments& a) { return std::abs(a.y) >= 0x1p-126 && std::abs(a.y) <= 0x1p126; }
// A reciprocal below the normal numbers is flushed by no one, but has lost digits.
bool normal_reciprocal(const Arguments& a) { return std::abs(a.x) <= 0x1p126; }
// The rounding of the product x log2(e) weighs as much as x is large: 2 + 1.17 |x| ULP, 104 at the ends.
bool power_in_range(const Arguments& a) { return a.x > 0 && std::isfinite(a.x) && std::isfinite(a.y); }

const MathFunction approximate_table[] = {
    {"half_cos",
     "half_cos(x)",
     Inputs::x,
     8192,
     absent,
     of_x<mpfr_cos>,
     {.from = -100, .to = 100, .defined = half_angle}},
    {"half_divide", "half_divide(x, y)", Inputs::xy, 8192, absent, of_xy<mpfr_div>, {.defined = divisor}},
    {"half_exp", "half_exp(x)", Inputs::x, 8192, absent, of_x<mpfr_exp>, {-90, 90}},
    {"half_exp10", "half_exp10(x)", Inputs::x, 8192, absent, of_x<mpfr_exp10>, {-38, 39}},
    {"half_exp2", "half_exp2(x)", Inputs::x, 8192, absent, of_x<mpfr_exp2>, {-126, 129}},
    {"half_log", "half_log(x)", Inputs::x, 8192, absent, of_x<mpfr_log>, {0, 10}},
    {"half_log10", "half_log10(x)", Inputs::x, 8192, absent, of_x<mpfr_log10>, {0, 10}},
    {"half_log2", "half_log2(x)", Inputs::x, 8192, absent, of_x<mpfr_log2>, {0, 10}},
    {"half_powr", "half_powr(x, y)", Inputs::xy, 8192, absent, powr, {0, 20}},
    {"half_recip", "half_recip(x)", Inputs::x, 8192, absent, reciprocal},
    {"half_rsqrt", "half_rsqrt(x)", Inputs::x, 8192, absent, rsqrt, {0, 10}},
    {"half_sin",
     "half_sin(x)",
     Inputs::x,
     8192,
     absent,
     of_x<mpfr_sin>,
     {.from = -100, .to = 100, .defined = half_angle}},
    {"half_sqrt", "half_sqrt(x)", Inputs::x, 8192, absent, of_x<mpfr_sqrt>, {0, 10}},
    {"half_tan",
     "half_tan(x)",
     Inputs::x,
     8192,
     absent,
     of_x<mpfr_tan>,
     {.from = -100, .to = 100, .defined = half_angle}},
    {"native_cos",
     "native_cos(x)",
     Inputs::x,
     1,
     absent,
     of_x<mpfr_cos>,
     {.from = -6.2,
      .to = 6.2,
      .defined = native_angle,
      .absolute = error_of_angle,
      .limit_text = "2^-20.5 absolute"}},
    {"native_divide", "native_divide(x, y)", Inputs::xy, 2, absent, of_xy<mpfr_div>, {.defined = divisor}},
    {"native_exp", "native_exp(x)", Inputs::x, 106, absent, of_x<mpfr_exp>, {-90, 90}},
    {"native_exp10", "native_exp10(x)", Inputs::x, 106, absent, of_x<mpfr_exp10>, {-38, 39}},
    {"native_exp2", "native_exp2(x)", Inputs::x, 2, absent, of_x<mpfr_exp2>, {-126, 129}},
    {"native_log",
     "native_log(x)",
     Inputs::x,
     4,
     absent,
     of_x<mpfr_log>,
     {.from = 0, .to = 10, .absolute = error_of_log, .limit_text = "4, or 2^-22 in (0.5, 2)"}},
    {"native_log10",
     "native_log10(x)",
     Inputs::x,
     4,
     absent,
     of_x<mpfr_log10>,
     {.from = 0, .to = 10, .absolute = error_of_log, .limit_text = "4, or 2^-22 in (0.5, 2)"}},
    {"native_log2",
     "native_log2(x)",
     Inputs::x,
     2,
     absent,
     of_x<mpfr_log2>,
     {.from = 0, .to = 10, .absolute = error_of_log, .limit_text = "2, or 2^-22 in (0.5, 2)"}},
    {"native_powr",
     "native_powr(x, y)",
     Inputs::xy,
     8192,
     absent,
     powr,
     {.from = 0, .to = 20, .defined = power_in_range}},
    {"native_recip", "native_recip(x)", Inputs::x, 1, absent, reciprocal, {.defined = normal_reciprocal}},
    {"native_rsqrt", "native_rsqrt(x)", Inputs::x, 2, absent, rsqrt, {0, 10}},
    {"native_sin",
     "native_sin(x)",
     Inputs::x,
     1,
     absent,
     of_x<mpfr_sin>,
     {.from = -6.2,
      .to = 6.2,
      .defined = native_angle,
      .absolute = error_of_angle,
      .limit_text = "2^-20.5 absolute"}},
    {"native_sqrt", "native_sqrt(x)", Inputs::x, 2, absent, of_x<mpfr_sqrt>, {0, 10}},
    {"native_tan",
     "native_tan(x)",
     Inputs::x,
     1,
     absent,
     of_x<mpfr_tan>,
     {.from = -1,
      .to = 1,
      .defined = native_tangent,
      .absolute = error_of_tangent,
      .limit_text = "2^-18 absolute within 1"}},
};

}  // namespace

std::span<const MathFunction> approximate_functions() { return approximate_table; }

}  // namespace warpgrain::profiler::builtins
