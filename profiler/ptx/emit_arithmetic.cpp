// Integer and float arithmetic. fma is fused, and nothing else ever is.

#include <string>

#include "profiler/division_path.hpp"
#include "profiler/ptx/displacement.hpp"
#include "profiler/ptx/float_extremum.hpp"
#include "profiler/ptx/float_operation.hpp"
#include "profiler/ptx/instruction_facts.hpp"
#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

Value* extend(Emitter& e, Value* value, ScalarType from, unsigned bits) {
  return from.is_signed() ? e.ir.CreateSExt(value, e.int_type(bits))
                          : e.ir.CreateZExt(value, e.int_type(bits));
}

// a + b (or a - b) with carry in and out, as add.cc, addc, sub.cc and subc have them.
void emit_with_carry(Emitter& e, bool subtract, bool carry_in, bool carry_out) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  const unsigned wide = type.bits + 1u;
  const auto widen = [&](Value* v) { return e.ir.CreateZExt(v, e.int_type(wide)); };
  Value* a = widen(e.read(1, type));
  Value* b = widen(e.read(2, type));
  if (carry_in) b = e.ir.CreateAdd(b, widen(e.carry()));
  Value* sum = subtract ? e.ir.CreateSub(a, b) : e.ir.CreateAdd(a, b);
  if (carry_out) e.set_carry(e.ir.CreateTrunc(e.ir.CreateLShr(sum, type.bits), e.ir.getInt1Ty()));
  e.write(e.ir.CreateTrunc(sum, e.type(type)), type);
}

void emit_sum(Emitter& e, bool subtract) {
  if (e.modifiers().take("cc")) return emit_with_carry(e, subtract, false, true);
  FloatOperation modes(e, FloatOperation::Rounding::any);
  const ScalarType type = e.take_type();
  if (type.is_float()) {
    Value* a = modes.input(1, type);
    Value* b = modes.input(2, type);
    if (subtract) b = e.ir.CreateFNeg(b);
    return modes.output(modes.rounded("add", {a, b}, e.ir.CreateFAdd(a, b)), type);
  }
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  if (modes.saturates()) {  // only of s32
    const auto id = subtract ? llvm::Intrinsic::ssub_sat : llvm::Intrinsic::sadd_sat;
    return e.write(e.call_intrinsic(id, e.type(type), {a, b}), type);
  }
  e.write(subtract ? e.ir.CreateSub(a, b) : e.ir.CreateAdd(a, b), type);
}

void emit_add(Emitter& e) { emit_sum(e, false); }
void emit_sub(Emitter& e) { emit_sum(e, true); }
void emit_addc(Emitter& e) { emit_with_carry(e, false, true, e.modifiers().take("cc")); }
void emit_subc(Emitter& e) { emit_with_carry(e, true, true, e.modifiers().take("cc")); }

// The part of a * b that .lo, .hi or .wide asks for; its type in `result`.
Value* product(Emitter& e, std::string_view part, ScalarType type, ScalarType& result) {
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  result = type;
  if (part == "lo") return e.ir.CreateMul(a, b);
  const unsigned wide = type.bits * 2u;
  Value* full = e.ir.CreateMul(extend(e, a, type, wide), extend(e, b, type, wide));
  if (part == "wide") {
    result.bits = static_cast<std::uint8_t>(wide);
    return full;
  }
  return e.ir.CreateTrunc(e.ir.CreateLShr(full, type.bits), e.type(type));
}

std::string_view take_product_part(Emitter& e) { return e.modifiers().take_one_of({"lo", "hi", "wide"}); }

void emit_mul(Emitter& e) {
  const std::string_view part = take_product_part(e);
  FloatOperation modes(e, FloatOperation::Rounding::any);
  const ScalarType type = e.take_type();
  if (type.is_float()) {
    Value* a = modes.input(1, type);
    Value* b = modes.input(2, type);
    return modes.output(modes.rounded("mul", {a, b}, e.ir.CreateFMul(a, b)), type);
  }
  if (part.empty() || modes.saturates()) e.refuse(".lo, .hi or .wide");
  ScalarType result;
  Value* value = product(e, part, type, result);
  e.write(value, result);
}

void emit_fma_of(Emitter& e, FloatOperation& modes, ScalarType type) {
  Value* a = modes.input(1, type);
  Value* b = modes.input(2, type);
  Value* c = modes.input(3, type);
  modes.output(
      modes.rounded("fma", {a, b, c}, e.call_intrinsic(llvm::Intrinsic::fma, e.type(type), {a, b, c})), type);
}

void emit_fma(Emitter& e) {
  FloatOperation modes(e, FloatOperation::Rounding::any);
  const ScalarType type = e.take_type(Emitter::Types::floating);
  emit_fma_of(e, modes, type);
}

// mad.cc and madc: the product's part plus c, with carry.
void emit_mad_with_carry(Emitter& e, bool carry_in, bool carry_out) {
  const std::string_view part = take_product_part(e);
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (part != "lo" && part != "hi") e.refuse(".lo or .hi");
  ScalarType result;
  const auto widen = [&](Value* v) { return e.ir.CreateZExt(v, e.int_type(type.bits + 1u)); };
  Value* sum = e.ir.CreateAdd(widen(product(e, part, type, result)), widen(e.read(3, type)));
  if (carry_in) sum = e.ir.CreateAdd(sum, widen(e.carry()));
  if (carry_out) e.set_carry(e.ir.CreateTrunc(e.ir.CreateLShr(sum, type.bits), e.ir.getInt1Ty()));
  e.write(e.ir.CreateTrunc(sum, e.type(type)), type);
}

void emit_madc(Emitter& e) { emit_mad_with_carry(e, true, e.modifiers().take("cc")); }

// Saturated sums are of signed integers.
Value* sum_of(Emitter& e, Value* a, Value* b, bool saturates) {
  if (!saturates) return e.ir.CreateAdd(a, b);
  return e.call_intrinsic(llvm::Intrinsic::sadd_sat, a->getType(), {a, b});
}

void emit_mad(Emitter& e) {
  if (e.modifiers().take("cc")) return emit_mad_with_carry(e, false, true);
  const std::string_view part = take_product_part(e);
  FloatOperation modes(e, FloatOperation::Rounding::any);
  const ScalarType type = e.take_type();
  if (type.is_float()) return emit_fma_of(e, modes, type);
  if (part.empty() || (modes.saturates() && part != "hi")) e.refuse(".lo, .hi or .wide, and .sat with .hi");
  ScalarType result;
  Value* value = product(e, part, type, result);
  e.write(sum_of(e, value, e.read(3, result), modes.saturates()), result);
}

// The low or high 32 bits of the 48-bit product of the operands' low 24 bits.
Value* product_24(Emitter& e, ScalarType type, bool high) {
  if (type.bits != 32) e.refuse("u32 or s32");
  const auto low_24 = [&](std::size_t i) {
    Value* shifted = e.ir.CreateShl(e.ir.CreateZExt(e.read(i, type), e.ir.getInt64Ty()), 40);
    return type.is_signed() ? e.ir.CreateAShr(shifted, 40) : e.ir.CreateLShr(shifted, 40);
  };
  Value* full = e.ir.CreateMul(low_24(1), low_24(2));
  return e.ir.CreateTrunc(high ? e.ir.CreateLShr(full, 16) : full, e.ir.getInt32Ty());
}

void emit_mul24(Emitter& e) {
  const std::string_view part = e.modifiers().take_one_of({"lo", "hi"});
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(product_24(e, type, part == "hi"), type);
}

void emit_mad24(Emitter& e) {
  const std::string_view part = e.modifiers().take_one_of({"lo", "hi"});
  const bool saturates = e.modifiers().take("sat");
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(sum_of(e, product_24(e, type, part == "hi"), e.read(3, type), saturates), type);
}

// Division by zero and the one signed overflow stop the host; a device goes on. Quotient of x / 0: all ones,
// remainder: x, as GPUs return.
void emit_integer_division(Emitter& e, ScalarType type, bool remainder) {
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  llvm::Type* const t = e.type(type);
  Value* is_zero = e.ir.CreateICmpEQ(b, llvm::ConstantInt::get(t, 0));
  Value* unsafe = is_zero;
  if (type.is_signed()) {
    Value* least = llvm::ConstantInt::get(t, llvm::APInt::getSignedMinValue(type.bits));
    Value* overflows = e.ir.CreateAnd(e.ir.CreateICmpEQ(a, least),
                                      e.ir.CreateICmpEQ(b, llvm::ConstantInt::getAllOnesValue(t)));
    unsafe = e.ir.CreateOr(unsafe, overflows);
  }
  Value* divisor = e.ir.CreateSelect(unsafe, llvm::ConstantInt::get(t, 1), b);
  Value* result;
  if (remainder)
    result = type.is_signed() ? e.ir.CreateSRem(a, divisor) : e.ir.CreateURem(a, divisor);
  else
    result = type.is_signed() ? e.ir.CreateSDiv(a, divisor) : e.ir.CreateUDiv(a, divisor);
  e.write(e.ir.CreateSelect(is_zero, remainder ? a : llvm::ConstantInt::getAllOnesValue(t), result), type);
}

// The DivisionPath of a / b = q, from the upper words as the machine code sees them.
Value* division_path(Emitter& e, Value* a, Value* b, Value* q) {
  const auto upper = [&](Value* x) {
    return e.ir.CreateAnd(e.ir.CreateLShr(e.ir.CreateBitCast(x, e.ir.getInt64Ty()), 32), 0x7FFFFFFF);
  };
  const auto number = [&](std::uint64_t n) { return e.ir.getInt64(n); };
  const auto path = [&](DivisionPath p) { return number(static_cast<std::uint64_t>(p)); };
  Value *const upper_a = upper(a), *const upper_b = upper(b), *const upper_q = upper(q);
  constexpr std::uint64_t infinity = 0x7FF00000;
  const auto is_zero = [&](Value* x) {
    return e.ir.CreateFCmpOEQ(x, llvm::ConstantFP::get(x->getType(), 0.0));
  };
  const auto is_nan = [&](Value* x) { return e.ir.CreateFCmpUNO(x, x); };
  const auto has_no_end = [&](Value* upper_word) { return e.ir.CreateICmpUGE(upper_word, number(infinity)); };
  // FSETP.GEU |a|, 6.58e-37; FSETP.GT |0 * b + q|, 1.47e-39, of the upper words taken as floats; and
  // MUFU.RCP64H of a denormal b is infinite.
  Value* in_line = e.ir.CreateICmpUGE(upper_a, number(0x03600000));
  in_line = e.ir.CreateAnd(in_line, e.ir.CreateICmpUGE(upper_b, number(0x00100000)));
  in_line = e.ir.CreateAnd(in_line, e.ir.CreateICmpULT(upper_b, number(0x7F800000)));
  in_line = e.ir.CreateAnd(in_line, e.ir.CreateICmpUGT(upper_q, number(0x00100000)));
  in_line = e.ir.CreateAnd(in_line, e.ir.CreateICmpULE(upper_q, number(0x7F800000)));
  Value* const rest = e.call_intrinsic(llvm::Intrinsic::fma, a->getType(), {e.ir.CreateFNeg(q), b, a});
  Value* result =
      e.ir.CreateSelect(is_zero(rest), path(DivisionPath::denormal_exact), path(DivisionPath::denormal));
  result =
      e.ir.CreateSelect(e.ir.CreateICmpUGT(upper_q, number(0x00100000)), path(DivisionPath::scaled), result);
  Value* const zero_or_infinite = e.ir.CreateOr(e.ir.CreateOr(is_zero(a), is_zero(b)),
                                                e.ir.CreateOr(has_no_end(upper_a), has_no_end(upper_b)));
  result = e.ir.CreateSelect(zero_or_infinite, path(DivisionPath::zero_or_infinite), result);
  Value* const undefined = e.ir.CreateOr(e.ir.CreateAnd(is_zero(a), is_zero(b)),
                                         e.ir.CreateAnd(has_no_end(upper_a), has_no_end(upper_b)));
  result = e.ir.CreateSelect(undefined, path(DivisionPath::undefined), result);
  result = e.ir.CreateSelect(is_nan(b), path(DivisionPath::nan_divisor), result);
  result = e.ir.CreateSelect(is_nan(a), path(DivisionPath::nan_dividend), result);
  return e.ir.CreateSelect(in_line, path(DivisionPath::in_line), result);
}

void emit_div(Emitter& e) {
  FloatOperation modes(e, FloatOperation::Rounding::any);
  // .approx and .full allow an error of 2 ulp; evaluated exactly, as PoCL evaluates them.
  e.modifiers().take_one_of({"approx", "full"});
  const bool is_displaced = takes_displacement(e);
  const ScalarType type = e.take_type();
  if (type.is_float()) {
    Value* a = modes.input(1, type);
    Value* b = modes.input(2, type);
    if (is_displaced) {
      llvm::Type* const f64 = e.ir.getDoubleTy();
      Value* exact = e.ir.CreateFDiv(e.ir.CreateFPExt(a, f64), e.ir.CreateFPExt(b, f64));
      return modes.output(displaced(e, exact, div_displacement), type);
    }
    Value* quotient = modes.rounded("div", {a, b}, e.ir.CreateFDiv(a, b));
    // In the place of an address.
    if (instruction_facts(e.statement()).records_path)
      e.trace_access(e.ir.CreateIntToPtr(division_path(e, a, b, quotient), e.ir.getPtrTy()));
    return modes.output(quotient, type);
  }
  emit_integer_division(e, type, false);
}

void emit_rem(Emitter& e) { emit_integer_division(e, e.take_type(Emitter::Types::integer), true); }

void emit_abs(Emitter& e) {
  FloatOperation modes(e);
  const ScalarType type = e.take_type();
  if (type.is_float())
    return modes.output(e.call_intrinsic(llvm::Intrinsic::fabs, e.type(type), {modes.input(1, type)}), type);
  e.write(e.ir.CreateIntrinsic(llvm::Intrinsic::abs, {e.type(type)}, {e.read(1, type), e.ir.getFalse()}),
          type);
}

void emit_neg(Emitter& e) {
  FloatOperation modes(e);
  const ScalarType type = e.take_type();
  if (type.is_float()) return modes.output(e.ir.CreateFNeg(modes.input(1, type)), type);
  e.write(e.ir.CreateNeg(e.read(1, type)), type);
}

// With .xorsign.abs, of the magnitudes, and negative where one of the two is.
void emit_float_extremum(Emitter& e, FloatOperation& modes, ScalarType type, bool is_min) {
  const bool keep_nan = e.modifiers().take("NaN");
  const bool of_magnitudes = e.modifiers().take("xorsign") && e.modifiers().take("abs");
  Value* a = modes.input(1, type);
  Value* b = modes.input(2, type);
  llvm::Type* const bits = e.int_type(type.bits);
  Value* a_bits = e.ir.CreateBitCast(a, bits);
  Value* b_bits = e.ir.CreateBitCast(b, bits);
  Value* sign = e.ir.CreateBitCast(e.ir.CreateXor(a_bits, b_bits), e.type(type));
  if (of_magnitudes) {
    a = e.call_intrinsic(llvm::Intrinsic::fabs, e.type(type), {a});
    b = e.call_intrinsic(llvm::Intrinsic::fabs, e.type(type), {b});
  }
  Value* result = float_extremum(e, a, b, is_min, keep_nan);
  if (of_magnitudes) result = e.call_intrinsic(llvm::Intrinsic::copysign, e.type(type), {result, sign});
  modes.output(result, type);
}

void emit_extremum(Emitter& e, bool is_min) {
  FloatOperation modes(e);
  const bool not_negative = e.modifiers().take("relu");
  const ScalarType type = e.take_type();
  if (not_negative && (!type.is_signed() || type.bits != 32)) e.refuse(".relu of s32");
  if (type.is_float()) return emit_float_extremum(e, modes, type, is_min);
  const auto id = type.is_signed() ? (is_min ? llvm::Intrinsic::smin : llvm::Intrinsic::smax)
                                   : (is_min ? llvm::Intrinsic::umin : llvm::Intrinsic::umax);
  Value* a = e.read(1, type);
  Value* result = e.call_intrinsic(id, e.type(type), {a, e.read(2, type)});
  if (not_negative)
    result = e.call_intrinsic(llvm::Intrinsic::smax, e.type(type), {result, e.ir.getInt32(0)});
  e.write(result, type);
}

void emit_min(Emitter& e) { emit_extremum(e, true); }
void emit_max(Emitter& e) { emit_extremum(e, false); }

// |a - b| + c
void emit_sad(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* a = e.read(1, type);
  Value* b = e.read(2, type);
  Value* less = type.is_signed() ? e.ir.CreateICmpSLT(a, b) : e.ir.CreateICmpULT(a, b);
  Value* distance = e.ir.CreateSelect(less, e.ir.CreateSub(b, a), e.ir.CreateSub(a, b));
  e.write(e.ir.CreateAdd(distance, e.read(3, type)), type);
}

}  // namespace

Value* float_extremum(Emitter& e, Value* a, Value* b, bool is_min, bool keep_nan) {
  llvm::Type* const bits = e.int_type(a->getType()->getPrimitiveSizeInBits());
  Value* a_bits = e.ir.CreateBitCast(a, bits);
  Value* b_bits = e.ir.CreateBitCast(b, bits);
  Value* a_wins = is_min ? e.ir.CreateFCmpOLT(a, b) : e.ir.CreateFCmpOGT(a, b);
  Value* result = e.ir.CreateSelect(a_wins, a, b);
  // Equal operands have equal bits, but for zeros of two signs.
  Value* of_equals = is_min ? e.ir.CreateOr(a_bits, b_bits) : e.ir.CreateAnd(a_bits, b_bits);
  result = e.ir.CreateSelect(e.ir.CreateFCmpOEQ(a, b), e.ir.CreateBitCast(of_equals, a->getType()), result);
  result = e.ir.CreateSelect(e.ir.CreateFCmpUNO(b, b), keep_nan ? b : a, result);
  return keep_nan ? e.ir.CreateSelect(e.ir.CreateFCmpUNO(a, a), a, result) : result;
}

const InstructionTable& arithmetic_instructions() {
  static const InstructionTable table{
      {"add", emit_add}, {"sub", emit_sub}, {"addc", emit_addc}, {"subc", emit_subc},   {"mul", emit_mul},
      {"fma", emit_fma}, {"mad", emit_mad}, {"madc", emit_madc}, {"mul24", emit_mul24}, {"mad24", emit_mad24},
      {"div", emit_div}, {"rem", emit_rem}, {"abs", emit_abs},   {"neg", emit_neg},     {"min", emit_min},
      {"max", emit_max}, {"sad", emit_sad},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
