#pragma once
// Written by scripts/builtin_polynomials.py; do not edit. Polynomials behind the built-in functions.

#include "profiler/builtins/vectors.h"

// (log(1 + t) - t + t^2 / 2) / t^3: within 2^-26.6
WARPGRAIN_INLINE float warpgrain_log1p_polynomial(float t) {
  float p = -0x1.b562460000000p-4f;
  p = fma(p, t, 0x1.dba2600000000p-4f);
  p = fma(p, t, -0x1.8fc5f60000000p-4f);
  p = fma(p, t, 0x1.bc8cf80000000p-4f);
  p = fma(p, t, -0x1.0033100000000p-3f);
  p = fma(p, t, 0x1.24c9260000000p-3f);
  p = fma(p, t, -0x1.55549e0000000p-3f);
  p = fma(p, t, 0x1.9998d40000000p-3f);
  p = fma(p, t, -0x1.0000000000000p-2f);
  p = fma(p, t, 0x1.5555560000000p-2f);
  return p;
}

// (log((1 + u) / (1 - u)) - 2 u) / u^3, of u^2: within 2^-25.1
WARPGRAIN_INLINE float warpgrain_atanh_polynomial(float t) {
  float p = 0x1.e66d700000000p-3f;
  p = fma(p, t, 0x1.242c5a0000000p-2f);
  p = fma(p, t, 0x1.999a6c0000000p-2f);
  p = fma(p, t, 0x1.5555560000000p-1f);
  return p;
}

// (sin(r) - r) / r^3, of r^2: within 2^-25.3
WARPGRAIN_INLINE float warpgrain_sin_polynomial(float t) {
  float p = -0x1.9ac2ca0000000p-13f;
  p = fma(p, t, 0x1.110c1c0000000p-7f);
  p = fma(p, t, -0x1.5555520000000p-3f);
  return p;
}

// (sin(r) - r) / r^3, of r^2: within 2^-56.6
WARPGRAIN_INLINE double warpgrain_sin_polynomial(double t) {
  double p = -0x1.ab13654fd392ap-41;
  p = fma(p, t, 0x1.61217781a8ccdp-33);
  p = fma(p, t, -0x1.ae6454093c147p-26);
  p = fma(p, t, 0x1.71de3a545b148p-19);
  p = fma(p, t, -0x1.a01a01a01990ap-13);
  p = fma(p, t, 0x1.1111111111110p-7);
  p = fma(p, t, -0x1.5555555555555p-3);
  return p;
}

// (cos(r) - 1 + r^2 / 2) / r^4, of r^2: within 2^-28.6
WARPGRAIN_INLINE float warpgrain_cos_polynomial(float t) {
  float p = 0x1.9bd3140000000p-16f;
  p = fma(p, t, -0x1.6c12c80000000p-10f);
  p = fma(p, t, 0x1.5555540000000p-5f);
  return p;
}

// (cos(r) - 1 + r^2 / 2) / r^4, of r^2: within 2^-58.6
WARPGRAIN_INLINE double warpgrain_cos_polynomial(double t) {
  double p = 0x1.ab746999271a1p-45;
  p = fma(p, t, -0x1.9394b3581cec8p-37);
  p = fma(p, t, 0x1.1eed8de759d0dp-29);
  p = fma(p, t, -0x1.27e4fb7710638p-22);
  p = fma(p, t, 0x1.a01a01a019cf6p-16);
  p = fma(p, t, -0x1.6c16c16c16c16p-10);
  p = fma(p, t, 0x1.5555555555555p-5);
  return p;
}

// (tan(r) - r) / r^3, of r^2: within 2^-22.8
WARPGRAIN_INLINE float warpgrain_tan_polynomial(float t) {
  float p = 0x1.0fc6960000000p-7f;
  p = fma(p, t, 0x1.4a27a20000000p-8f);
  p = fma(p, t, 0x1.7bf4a40000000p-6f);
  p = fma(p, t, 0x1.b879900000000p-5f);
  p = fma(p, t, 0x1.1116ba0000000p-3f);
  p = fma(p, t, 0x1.5555500000000p-2f);
  return p;
}

// (tan(r) - r) / r^3, of r^2: within 2^-55.0
WARPGRAIN_INLINE double warpgrain_tan_polynomial(double t) {
  double p = 0x1.200c85313d514p-17;
  p = fma(p, t, -0x1.3a58fd3d54411p-16);
  p = fma(p, t, 0x1.38e08c8565625p-15);
  p = fma(p, t, -0x1.8e2a4ee9cbf83p-17);
  p = fma(p, t, 0x1.d76585075c74ap-15);
  p = fma(p, t, 0x1.782eed53dae15p-14);
  p = fma(p, t, 0x1.fa19b32d00184p-13);
  p = fma(p, t, 0x1.35183dfeedf0ap-11);
  p = fma(p, t, 0x1.7da84015bd5b1p-10);
  p = fma(p, t, 0x1.d6d39059cc533p-9);
  p = fma(p, t, 0x1.226e36750aa16p-7);
  p = fma(p, t, 0x1.664f487d1cc8ep-6);
  p = fma(p, t, 0x1.ba1ba1ba2ae7ap-5);
  p = fma(p, t, 0x1.111111111108fp-3);
  p = fma(p, t, 0x1.5555555555555p-2);
  return p;
}

// (tanh(x) - x) / x^3, of x^2: within 2^-24.3
WARPGRAIN_INLINE float warpgrain_tanh_polynomial(float t) {
  float p = -0x1.971e640000000p-8f;
  p = fma(p, t, 0x1.5948600000000p-6f);
  p = fma(p, t, -0x1.b946c20000000p-5f);
  p = fma(p, t, 0x1.110ea40000000p-3f);
  p = fma(p, t, -0x1.5555540000000p-2f);
  return p;
}

// (sinh(x) - x) / x^3, of x^2: within 2^-27.5
WARPGRAIN_INLINE float warpgrain_sinh_polynomial(float t) {
  float p = 0x1.78a70e0000000p-19f;
  p = fma(p, t, 0x1.a009000000000p-13f);
  p = fma(p, t, 0x1.11111e0000000p-7f);
  p = fma(p, t, 0x1.5555560000000p-3f);
  return p;
}

// (atan(x) - x) / x^3, of x^2: within 2^-25.6
WARPGRAIN_INLINE float warpgrain_atan_polynomial(float t) {
  float p = -0x1.38de560000000p-9f;
  p = fma(p, t, 0x1.ba9f660000000p-7f);
  p = fma(p, t, -0x1.25dc120000000p-5f);
  p = fma(p, t, 0x1.0001c60000000p-4f);
  p = fma(p, t, -0x1.6295f80000000p-4f);
  p = fma(p, t, 0x1.c3f1680000000p-4f);
  p = fma(p, t, -0x1.246cd20000000p-3f);
  p = fma(p, t, 0x1.99983c0000000p-3f);
  p = fma(p, t, -0x1.5555540000000p-2f);
  return p;
}

// (atan(x) - x) / x^3, of x^2: within 2^-54.8
WARPGRAIN_INLINE double warpgrain_atan_polynomial(double t) {
  double p = -0x1.8d087295ab9f4p-17;
  p = fma(p, t, 0x1.1f0adb240a1fbp-13);
  p = fma(p, t, -0x1.8a2f3ae537bb1p-11);
  p = fma(p, t, 0x1.57cc888719aa0p-9);
  p = fma(p, t, -0x1.aef1a8e977bf8p-8);
  p = fma(p, t, 0x1.a1fe88baf72d4p-7);
  p = fma(p, t, -0x1.4b974a27ac39fp-6);
  p = fma(p, t, 0x1.c3ac54a572735p-6);
  p = fma(p, t, -0x1.147b2825d82f6p-5);
  p = fma(p, t, 0x1.3d3f26d5ea7ffp-5);
  p = fma(p, t, -0x1.60ebd1489b946p-5);
  p = fma(p, t, 0x1.854a7b99af61dp-5);
  p = fma(p, t, -0x1.af00bd568a3d2p-5);
  p = fma(p, t, 0x1.e1dc0d7679adcp-5);
  p = fma(p, t, -0x1.1110bfea8ed5ep-4);
  p = fma(p, t, 0x1.3b13aaf4aba4ap-4);
  p = fma(p, t, -0x1.745d16f26d0a3p-4);
  p = fma(p, t, 0x1.c71c71c472843p-4);
  p = fma(p, t, -0x1.249249248c7dap-3);
  p = fma(p, t, 0x1.99999999998f9p-3);
  p = fma(p, t, -0x1.5555555555555p-2);
  return p;
}

// (exp(r) - 1 - r - r^2 / 2) / r^3: within 2^-56.5
WARPGRAIN_INLINE double warpgrain_expm1_polynomial(double t) {
  double p = 0x1.af1df95acb585p-41;
  p = fma(p, t, 0x1.943fe3d2a92a4p-37);
  p = fma(p, t, 0x1.612449514a3e6p-33);
  p = fma(p, t, 0x1.1eed759da240dp-29);
  p = fma(p, t, 0x1.ae645682c9d66p-26);
  p = fma(p, t, 0x1.27e4fb7b34f6ap-22);
  p = fma(p, t, 0x1.71de3a556c34ep-19);
  p = fma(p, t, 0x1.a01a01a0197dbp-16);
  p = fma(p, t, 0x1.a01a01a01a01ap-13);
  p = fma(p, t, 0x1.6c16c16c16c17p-10);
  p = fma(p, t, 0x1.1111111111111p-7);
  p = fma(p, t, 0x1.5555555555555p-5);
  p = fma(p, t, 0x1.5555555555555p-3);
  return p;
}

// (erf(x) - x) / x, of x^2: within 2^-27.5
WARPGRAIN_INLINE float warpgrain_erf_polynomial(float t) {
  float p = 0x1.4a56900000000p-14f;
  p = fma(p, t, -0x1.a450880000000p-11f);
  p = fma(p, t, 0x1.5412700000000p-8f);
  p = fma(p, t, -0x1.b7faba0000000p-6f);
  p = fma(p, t, 0x1.ce2d100000000p-4f);
  p = fma(p, t, -0x1.81273e0000000p-2f);
  p = fma(p, t, 0x1.06eba80000000p-3f);
  return p;
}

// (erf(x) - x) / x, of x^2: within 2^-56.2
WARPGRAIN_INLINE double warpgrain_erf_polynomial(double t) {
  double p = -0x1.29b9f1b3df556p-38;
  p = fma(p, t, 0x1.7f072188e194dp-34);
  p = fma(p, t, -0x1.4e607b41a6416p-30);
  p = fma(p, t, 0x1.fc4356498c2d9p-27);
  p = fma(p, t, -0x1.5f6d925a0bc7ap-23);
  p = fma(p, t, 0x1.b9e6509b9867dp-20);
  p = fma(p, t, -0x1.f4d2561aeafd4p-17);
  p = fma(p, t, 0x1.f9a326c233146p-14);
  p = fma(p, t, -0x1.c02db3feeb579p-11);
  p = fma(p, t, 0x1.565bcd0e6502dp-8);
  p = fma(p, t, -0x1.b82ce312889bap-6);
  p = fma(p, t, 0x1.ce2f21a042bdep-4);
  p = fma(p, t, -0x1.812746b0379e7p-2);
  p = fma(p, t, 0x1.06eba8214db69p-3);
  return p;
}

// (1 + 2 x) exp(x^2) erfc(x), of (x - 4) / (x + 4), x from 0 to 28: within 2^-23.0
WARPGRAIN_INLINE float warpgrain_erfc_polynomial(float t) {
  float p = -0x1.a982c80000000p-17f;
  p = fma(p, t, 0x1.3af75a0000000p-8f);
  p = fma(p, t, -0x1.1866ec0000000p-6f);
  p = fma(p, t, 0x1.30fcc20000000p-5f);
  p = fma(p, t, -0x1.0dd2160000000p-4f);
  p = fma(p, t, 0x1.7fef2a0000000p-4f);
  p = fma(p, t, -0x1.9e41640000000p-4f);
  p = fma(p, t, 0x1.16eb820000000p-4f);
  p = fma(p, t, 0x1.f834aa0000000p-7f);
  p = fma(p, t, -0x1.1df1a80000000p-3f);
  p = fma(p, t, 0x1.3ba5900000000p+0f);
  return p;
}

// (1 + 2 x) exp(x^2) erfc(x), of (x - 4) / (x + 4), x from 0 to 28: within 2^-53.7
WARPGRAIN_INLINE double warpgrain_erfc_polynomial(double t) {
  double p = -0x1.f47207b168acdp-30;
  p = fma(p, t, -0x1.d5bb4c6d5b92dp-27);
  p = fma(p, t, -0x1.09198a32cd9a9p-27);
  p = fma(p, t, 0x1.ef6c0c38d1a2bp-24);
  p = fma(p, t, 0x1.0d535fce28f99p-24);
  p = fma(p, t, -0x1.c05fc977974eap-21);
  p = fma(p, t, 0x1.4392983419eddp-22);
  p = fma(p, t, 0x1.7fb88e391a9fep-18);
  p = fma(p, t, -0x1.78a43458cca4bp-17);
  p = fma(p, t, -0x1.996ad056e530bp-16);
  p = fma(p, t, 0x1.3be0b393ee921p-13);
  p = fma(p, t, -0x1.a1de7c6e9ac9cp-13);
  p = fma(p, t, -0x1.8d4a9dc0d22f3p-11);
  p = fma(p, t, 0x1.49c671893963fp-8);
  p = fma(p, t, -0x1.0962388367b2fp-6);
  p = fma(p, t, 0x1.3079edfa1033fp-5);
  p = fma(p, t, -0x1.0fb06dfe46987p-4);
  p = fma(p, t, 0x1.7fee004df6263p-4);
  p = fma(p, t, -0x1.9ddb23c3e98a6p-4);
  p = fma(p, t, 0x1.16ecefcfa6077p-4);
  p = fma(p, t, 0x1.f7f5df66fd951p-7);
  p = fma(p, t, -0x1.1df1ad154a29cp-3);
  p = fma(p, t, 0x1.3ba5916e9fd7fp+0);
  return p;
}

// log(gamma(2 + t)) / t: within 2^-26.8
WARPGRAIN_INLINE float warpgrain_log_gamma_polynomial(float t) {
  float p = 0x1.dbf0840000000p-14f;
  p = fma(p, t, -0x1.0a25820000000p-12f);
  p = fma(p, t, 0x1.098f940000000p-11f);
  p = fma(p, t, -0x1.36ddb80000000p-10f);
  p = fma(p, t, 0x1.7ae6fe0000000p-9f);
  p = fma(p, t, -0x1.e40f700000000p-8f);
  p = fma(p, t, 0x1.5132220000000p-6f);
  p = fma(p, t, -0x1.13dffc0000000p-4f);
  p = fma(p, t, 0x1.4a34cc0000000p-2f);
  p = fma(p, t, 0x1.b0ee600000000p-2f);
  return p;
}

// log(gamma(2 + t)) / t: within 2^-55.9
WARPGRAIN_INLINE double warpgrain_log_gamma_polynomial(double t) {
  double p = -0x1.cb7e44a624a8ap-32;
  p = fma(p, t, 0x1.d687b6664064ep-31);
  p = fma(p, t, -0x1.26f3ee041c857p-30);
  p = fma(p, t, 0x1.360cdce0cb3d0p-29);
  p = fma(p, t, -0x1.681d23c1006eep-28);
  p = fma(p, t, 0x1.77f952dd279c8p-27);
  p = fma(p, t, -0x1.85df26445cd52p-26);
  p = fma(p, t, 0x1.9976d91c92d3dp-25);
  p = fma(p, t, -0x1.af5e85addec12p-24);
  p = fma(p, t, 0x1.c76f0038db56bp-23);
  p = fma(p, t, -0x1.e25fe65e7324fp-22);
  p = fma(p, t, 0x1.0064bfaaf95bep-20);
  p = fma(p, t, -0x1.11b2ebfc0a0e6p-19);
  p = fma(p, t, 0x1.2597a3f54c791p-18);
  p = fma(p, t, -0x1.3cbc963a5ca7bp-17);
  p = fma(p, t, 0x1.580dcee50b76fp-16);
  p = fma(p, t, -0x1.78de5bd7d09f7p-15);
  p = fma(p, t, 0x1.a127b0f1812e1p-14);
  p = fma(p, t, -0x1.d3fd4c76d2e92p-13);
  p = fma(p, t, 0x1.0b36af86396b5p-11);
  p = fma(p, t, -0x1.38ac5c2bf8e09p-10);
  p = fma(p, t, 0x1.7add6eadb6c30p-9);
  p = fma(p, t, -0x1.e404fc218f5f2p-8);
  p = fma(p, t, 0x1.51322ac7d8483p-6);
  p = fma(p, t, -0x1.13e001a557607p-4);
  p = fma(p, t, 0x1.4a34cc4a60fa6p-2);
  p = fma(p, t, 0x1.b0ee6072093cep-2);
  return p;
}

// gamma(x) / (sqrt(2 pi) x^(x - 1/2) exp(-x)), of 1 / x, x from 10: within 2^-32.5
WARPGRAIN_INLINE float warpgrain_stirling_polynomial(float t) {
  float p = -0x1.62a2520000000p-9f;
  p = fma(p, t, 0x1.c7417a0000000p-9f);
  p = fma(p, t, 0x1.5555500000000p-4f);
  p = fma(p, t, 0x1.0000000000000p+0f);
  return p;
}

// gamma(x) / (sqrt(2 pi) x^(x - 1/2) exp(-x)), of 1 / x, x from 10: within 2^-60.4
WARPGRAIN_INLINE double warpgrain_stirling_polynomial(double t) {
  double p = 0x1.4992cb4a8ed2ep-11;
  p = fma(p, t, 0x1.27f62bdb39617p-17);
  p = fma(p, t, -0x1.3aa4323bb14bcp-11);
  p = fma(p, t, 0x1.26f950e541f47p-14);
  p = fma(p, t, 0x1.9b0c4e8364a3ep-11);
  p = fma(p, t, -0x1.e13c7e087e765p-13);
  p = fma(p, t, -0x1.5f72690732d55p-9);
  p = fma(p, t, 0x1.c71c71c74fea8p-9);
  p = fma(p, t, 0x1.5555555555541p-4);
  p = fma(p, t, 0x1.0000000000000p+0);
  return p;
}

// x (log(gamma(x)) - (x - 1/2) (log(x) - 1) - (log(2 pi) - 1) / 2), of 1 / x, x from 8: within 2^-27.6
WARPGRAIN_INLINE float warpgrain_log_stirling_polynomial(float t) {
  float p = 0x1.985f080000000p-13f;
  p = fma(p, t, -0x1.6e10e60000000p-9f);
  p = fma(p, t, 0x1.935b020000000p-22f);
  p = fma(p, t, 0x1.5555540000000p-4f);
  return p;
}

// x (log(gamma(x)) - (x - 1/2) (log(x) - 1) - (log(2 pi) - 1) / 2), of 1 / x, x from 8: within 2^-57.5
WARPGRAIN_INLINE double warpgrain_log_stirling_polynomial(double t) {
  double p = -0x1.5263e792c29bfp-11;
  p = fma(p, t, -0x1.edfc020b76bf7p-12);
  p = fma(p, t, 0x1.e5e38897749dep-11);
  p = fma(p, t, -0x1.32e68cb639171p-17);
  p = fma(p, t, -0x1.37bffb06fc247p-11);
  p = fma(p, t, -0x1.cfbb9c7143b62p-26);
  p = fma(p, t, 0x1.a01a1a9baae29p-11);
  p = fma(p, t, -0x1.91175eeb3d3f5p-37);
  p = fma(p, t, -0x1.6c16c16be33abp-9);
  p = fma(p, t, -0x1.4a1c636b8cf63p-52);
  p = fma(p, t, 0x1.5555555555555p-4);
  return p;
}

// 64 zero bits, then the bits of 2 / pi behind the point, highest first.
// clang-format off
constant ulong warpgrain_two_over_pi[] = {0,
    0xa2f9836e4e441529UL, 0xfc2757d1f534ddc0UL, 0xdb6295993c439041UL, 0xfe5163abdebbc561UL,
    0xb7246e3a424dd2e0UL, 0x06492eea09d1921cUL, 0xfe1deb1cb129a73eUL, 0xe88235f52ebb4484UL,
    0xe99c7026b45f7e41UL, 0x3991d639835339f4UL, 0x9c845f8bbdf9283bUL, 0x1ff897ffde05980fUL,
    0xef2f118b5a0a6d1fUL, 0x6d367ecf27cb09b7UL, 0x4f463f669e5fea2dUL, 0x7527bac7ebe5f17bUL,
    0x3d0739f78a5292eaUL, 0x6bfb5fb11f8d5d08UL, 0x56033046fc7b6babUL, 0xf0cfbc209af4361dUL,
    0xa9e391615ee61b08UL, 0x6599855f14a06840UL};
// clang-format on
