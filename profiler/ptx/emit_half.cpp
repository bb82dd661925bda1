// Arithmetic of f16 and f16x2, which is two of them in 32 bits.

#include "profiler/ptx/emit_half.hpp"

#include <algorithm>

#include "profiler/ptx/float_extremum.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

bool has(const Statement& statement, std::string_view modifier) {
  return std::find(statement.modifiers.begin(), statement.modifiers.end(), modifier) !=
         statement.modifiers.end();
}

// An instruction's modifiers, and its operands as halfs.
class HalfOperation {
 public:
  explicit HalfOperation(Emitter& e) : e_(e), packed_(has(e.statement(), "f16x2")) {
    e.modifiers().take("rn");
    flushes_ = e.modifiers().take("ftz");
    saturates_ = e.modifiers().take("sat");
    keeps_nan_ = e.modifiers().take("NaN");
    e.modifiers().take("approx");
    e.modifiers().take(packed_ ? "f16x2" : "f16");
  }

  bool keeps_nan() const { return keeps_nan_; }
  // One or two.
  unsigned count() const { return packed_ ? 2 : 1; }
  Value* input(std::size_t operand, unsigned element) const {
    Value* bits = e_.read(operand, bits_type(packed_ ? 32 : 16));
    Value* half = e_.ir.CreateTrunc(element == 1 ? e_.ir.CreateLShr(bits, 16) : bits, e_.ir.getInt16Ty());
    return flush(e_.ir.CreateBitCast(half, e_.ir.getHalfTy()));
  }
  // Every NaN is the one that PTX calls canonical.
  Value* finish(Value* half) const {
    half = flush(half);
    if (saturates_) half = saturate(e_, half);
    Value* nan = e_.ir.CreateBitCast(e_.ir.getInt16(0x7fff), e_.ir.getHalfTy());
    return e_.ir.CreateSelect(e_.ir.CreateFCmpUNO(half, half), nan, half);
  }
  void output(Value* first, Value* second) const {
    Value* bits = e_.ir.CreateBitCast(first, e_.ir.getInt16Ty());
    if (!packed_) return e_.write(bits, bits_type(16));
    Value* high = e_.ir.CreateZExt(e_.ir.CreateBitCast(second, e_.ir.getInt16Ty()), e_.ir.getInt32Ty());
    e_.write(e_.ir.CreateOr(e_.ir.CreateZExt(bits, e_.ir.getInt32Ty()), e_.ir.CreateShl(high, 16)),
             bits_type(32));
  }

 private:
  Value* flush(Value* half) const {
    if (!flushes_) return half;
    Value* bits = e_.ir.CreateBitCast(half, e_.ir.getInt16Ty());
    Value* is_small = e_.ir.CreateICmpULT(e_.ir.CreateAnd(bits, 0x7fff), e_.ir.getInt16(0x0400));
    return e_.ir.CreateBitCast(e_.ir.CreateSelect(is_small, e_.ir.CreateAnd(bits, 0x8000), bits),
                               e_.ir.getHalfTy());
  }

  Emitter& e_;
  bool packed_;
  bool flushes_, saturates_, keeps_nan_;
};

// `value(operation, element)` for each element.
template <class Function>
void emit_elements(Emitter& e, Function value) {
  const HalfOperation operation(e);
  Value* results[2] = {};
  for (unsigned i = 0; i < operation.count(); ++i) results[i] = operation.finish(value(operation, i));
  operation.output(results[0], results[1]);
}

// A float holds the exact result, or enough bits of it that rounding twice is as rounding once: 24 >= 2 11 +
// 2 (S. Figueroa, "When is double rounding innocuous?", 1995).
template <class Function>
void emit_in_float(Emitter& e, Function operation) {
  emit_elements(e, [&](const HalfOperation& half, unsigned i) {
    llvm::Type* const f32 = e.ir.getFloatTy();
    Value* a = e.ir.CreateFPExt(half.input(1, i), f32);
    Value* b = e.ir.CreateFPExt(half.input(2, i), f32);
    return e.ir.CreateFPTrunc(operation(a, b), e.ir.getHalfTy());
  });
}

void emit_add(Emitter& e) {
  emit_in_float(e, [&](Value* a, Value* b) { return e.ir.CreateFAdd(a, b); });
}
void emit_sub(Emitter& e) {
  emit_in_float(e, [&](Value* a, Value* b) { return e.ir.CreateFSub(a, b); });
}
void emit_mul(Emitter& e) {
  emit_in_float(e, [&](Value* a, Value* b) { return e.ir.CreateFMul(a, b); });
}

void emit_fma(Emitter& e) {
  const bool clamps = e.modifiers().take("relu");
  emit_elements(e, [&](const HalfOperation& half, unsigned i) -> Value* {
    const auto bits = [&](std::size_t operand) {
      return e.ir.CreateBitCast(half.input(operand, i), e.ir.getInt16Ty());
    };
    Value* result = e.call_host("warpgrain_fma_f16", e.ir.getInt16Ty(), {bits(1), bits(2), bits(3)});
    result = e.ir.CreateBitCast(result, e.ir.getHalfTy());
    if (!clamps) return result;
    Value* is_negative = e.ir.CreateFCmpOLT(result, llvm::ConstantFP::get(e.ir.getHalfTy(), 0.0));
    return e.ir.CreateSelect(is_negative, llvm::ConstantFP::get(e.ir.getHalfTy(), 0.0), result);
  });
}

// Only the sign changes.
void emit_sign(Emitter& e, bool negate) {
  emit_elements(e, [&](const HalfOperation& half, unsigned i) {
    Value* bits = e.ir.CreateBitCast(half.input(1, i), e.ir.getInt16Ty());
    bits = negate ? e.ir.CreateXor(bits, 0x8000) : e.ir.CreateAnd(bits, 0x7fff);
    return e.ir.CreateBitCast(bits, e.ir.getHalfTy());
  });
}
void emit_neg(Emitter& e) { emit_sign(e, true); }
void emit_abs(Emitter& e) { emit_sign(e, false); }

// As of the wider floats: one NaN gives the other operand, unless .NaN is asked for; -0 is below +0.
void emit_extremum(Emitter& e, bool is_min) {
  emit_elements(e, [&](const HalfOperation& half, unsigned i) {
    llvm::Type* const f32 = e.ir.getFloatTy();
    Value* a = e.ir.CreateFPExt(half.input(1, i), f32);
    Value* b = e.ir.CreateFPExt(half.input(2, i), f32);
    Value* extremum = float_extremum(e, a, b, is_min, half.keeps_nan());
    return e.ir.CreateFPTrunc(extremum, e.ir.getHalfTy());
  });
}
void emit_min(Emitter& e) { emit_extremum(e, true); }
void emit_max(Emitter& e) { emit_extremum(e, false); }

// ex2.approx.f16, tanh.approx.f16
void emit_half_host_function(Emitter& e) {
  emit_elements(e, [&](const HalfOperation& half, unsigned i) {
    Value* x = e.ir.CreateFPExt(half.input(1, i), e.ir.getFloatTy());
    Value* y = e.call_host("warpgrain_" + e.statement().opcode, e.ir.getFloatTy(), {x});
    return e.ir.CreateFPTrunc(y, e.ir.getHalfTy());
  });
}

}  // namespace

const InstructionTable& half_instructions() {
  static const InstructionTable table{
      {"add", emit_add},
      {"sub", emit_sub},
      {"mul", emit_mul},
      {"fma", emit_fma},
      {"neg", emit_neg},
      {"abs", emit_abs},
      {"min", emit_min},
      {"max", emit_max},
      {"ex2", emit_half_host_function},
      {"tanh", emit_half_host_function},
  };
  return table;
}

bool is_half_arithmetic(const Statement& statement) {
  return half_instructions().count(statement.opcode) != 0 &&
         (has(statement, "f16") || has(statement, "f16x2"));
}

}  // namespace warpgrain::profiler::ptx
