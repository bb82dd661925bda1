#pragma once
// The modifiers that float arithmetic shares: rounding, .ftz and .sat.

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

class FloatOperation {
 public:
  // Takes .rn, .ftz and .sat from the instruction at hand. Other roundings stay, so that it is refused.
  explicit FloatOperation(Emitter& emitter);

  bool saturates() const { return saturates_; }
  llvm::Value* input(std::size_t operand, ScalarType type);
  // Writes the result to the first operand.
  void output(llvm::Value* value, ScalarType type);

 private:
  Emitter& emitter_;
  bool flushes_;
  bool saturates_;
};

}  // namespace warpgrain::profiler::ptx
