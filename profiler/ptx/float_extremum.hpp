#pragma once
// min and max of floats of every width.

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

// One NaN gives the other operand, unless `keep_nan`; -0 is below +0.
llvm::Value* float_extremum(Emitter& emitter, llvm::Value* a, llvm::Value* b, bool is_min, bool keep_nan);

}  // namespace warpgrain::profiler::ptx
