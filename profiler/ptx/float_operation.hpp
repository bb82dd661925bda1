#pragma once
// The modifiers that float arithmetic shares: rounding, .ftz and .sat.

#include "profiler/ptx/emitter.hpp"

namespace warpgrain::profiler::ptx {

class FloatOperation {
 public:
  // Takes .rn, .ftz and .sat from the instruction at hand, and .rz, .rm and .rp of those that may be
  // directed. A modifier that stays gets the instruction refused.
  enum class Rounding : std::uint8_t { nearest, any };
  explicit FloatOperation(Emitter& emitter, Rounding rounding = Rounding::nearest);

  // The operation (add, mul, div, fma, sqrt) in the rounding asked for: `nearest`, or a call of the host's.
  llvm::Value* rounded(std::string_view operation, llvm::ArrayRef<llvm::Value*> inputs, llvm::Value* nearest);

  bool saturates() const { return saturates_; }
  bool flushes() const { return flushes_; }
  llvm::Value* input(std::size_t operand, ScalarType type);
  // Writes the result to the first operand.
  void output(llvm::Value* value, ScalarType type);

 private:
  Emitter& emitter_;
  std::string_view rounding_;
  bool flushes_;
  bool saturates_;
};

}  // namespace warpgrain::profiler::ptx
