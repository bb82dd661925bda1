#pragma once
// Results that are off by what the PTX ISA allows an approximate function (sections on floating-point
// instructions), the same for the same operands on every run.

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

// How far off a result may be beside its rounding to float, which takes half a unit, or 2^-24 of it.
struct Displacement {
  double relative = 0;  // of the result
  double ulps = 0;      // units in its last place
};
inline constexpr Displacement sqrt_displacement{0x1p-24, 0};       // sqrt.approx.f32: 2^-23
inline constexpr Displacement rsqrt_displacement{0x1.24bp-24, 0};  // rsqrt.approx.f32: 2^-22.9
inline constexpr Displacement rcp_displacement{0, 0.5};            // rcp.approx.f32: 1 ulp
inline constexpr Displacement div_displacement{0, 1.5};            // div.approx.f32, div.full.f32: 2 ulp

// Takes `.displaced` (profiler/approximate_ptx.hpp) from the instruction at hand.
bool takes_displacement(Emitter& e);

// `exact` (f64) moved by up to `bound` either way, how far being a hash of its bits, and rounded to f32.
llvm::Value* displaced(Emitter& e, llvm::Value* exact, const Displacement& bound);

}  // namespace warpgrain::profiler::ptx
