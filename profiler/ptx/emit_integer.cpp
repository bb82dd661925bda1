// Integer instructions of several steps: dot products of packed values, masks, and searches for bits.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

const ScalarType u32{ScalarType::Kind::unsigned_integer, 32};

// Element `index` of `bits` in a packed word, as 32 bits by the sign of `type`.
Value* unpacked(Emitter& e, Value* word, unsigned index, unsigned bits, ScalarType type) {
  Value* top = e.ir.CreateShl(word, 32 - (index + 1) * bits);
  return type.is_signed() ? e.ir.CreateAShr(top, 32 - bits) : e.ir.CreateLShr(top, 32 - bits);
}

// c + the products of four pairs of bytes, or of two 16-bit values and two bytes of b, low or high.
void emit_dot(Emitter& e, unsigned bits_of_a, unsigned first_of_b) {
  const ScalarType type_a = e.take_type(Emitter::Types::integer);
  const ScalarType type_b = e.take_type(Emitter::Types::integer);
  if (type_a.bits != 32 || type_b.bits != 32) e.refuse("u32 or s32");
  Value* a = e.read(1, type_a);
  Value* b = e.read(2, type_b);
  Value* sum = e.read(3, u32);
  for (unsigned i = 0; i < 32 / bits_of_a; ++i)
    sum = e.ir.CreateAdd(
        sum, e.ir.CreateMul(unpacked(e, a, i, bits_of_a, type_a), unpacked(e, b, first_of_b + i, 8, type_b)));
  e.write(sum, u32);
}

void emit_dp4a(Emitter& e) { emit_dot(e, 8, 0); }

void emit_dp2a(Emitter& e) {
  const std::string_view half = e.modifiers().take_one_of({"lo", "hi"});
  if (half.empty()) e.refuse(".lo or .hi");
  emit_dot(e, 16, half == "hi" ? 2 : 0);
}

// The lowest five bits, or what is beyond them made 32.
Value* bit_count(Emitter& e, std::size_t operand, bool wraps) {
  Value* count = e.read(operand, u32);
  return wraps ? e.ir.CreateAnd(count, 31)
               : e.call_intrinsic(llvm::Intrinsic::umin, e.ir.getInt32Ty(), {count, e.ir.getInt32(32)});
}

bool take_wraps(Emitter& e) {
  const std::string_view mode = e.modifiers().take_one_of({"clamp", "wrap"});
  if (mode.empty()) e.refuse(".clamp or .wrap");
  return mode == "wrap";
}

// `count` low ones in 64 bits, count up to 32
Value* ones_below(Emitter& e, Value* count) {
  Value* power = e.ir.CreateShl(e.ir.getInt64(1), e.ir.CreateZExt(count, e.ir.getInt64Ty()));
  return e.ir.CreateSub(power, e.ir.getInt64(1));
}

// b ones from bit a on
void emit_bmsk(Emitter& e) {
  const bool wraps = take_wraps(e);
  if (e.take_type(Emitter::Types::integer).bits != 32) e.refuse("b32");
  Value* position = e.ir.CreateZExt(bit_count(e, 1, wraps), e.ir.getInt64Ty());
  Value* mask = e.ir.CreateShl(ones_below(e, bit_count(e, 2, wraps)), position);
  e.write(e.ir.CreateTrunc(mask, e.ir.getInt32Ty()), u32);
}

// The low b bits of a, extended by their highest one or by zeros.
void emit_szext(Emitter& e) {
  const bool wraps = take_wraps(e);
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (type.bits != 32) e.refuse("u32 or s32");
  Value* count = bit_count(e, 2, wraps);
  Value* shift = e.ir.CreateZExt(e.ir.CreateSub(e.ir.getInt32(64), count), e.ir.getInt64Ty());
  Value* top = e.ir.CreateShl(e.ir.CreateZExt(e.read(1, type), e.ir.getInt64Ty()), shift);
  Value* result = type.is_signed() ? e.ir.CreateAShr(top, shift) : e.ir.CreateLShr(top, shift);
  Value* zero = e.ir.getInt32(0);
  e.write(
      e.ir.CreateSelect(e.ir.CreateICmpEQ(count, zero), zero, e.ir.CreateTrunc(result, e.ir.getInt32Ty())),
      type);
}

// fns.b32 d, mask, base, offset: the place of the offset-th set bit from `base` on, up or down.
void emit_fns(Emitter& e) {
  if (e.take_type(Emitter::Types::integer).bits != 32) e.refuse("b32");
  e.write(e.call_host("warpgrain_find_nth_set", e.ir.getInt32Ty(),
                      {e.read(1, u32), e.read(2, u32), e.read(3, u32)}),
          u32);
}

}  // namespace

const InstructionTable& integer_instructions() {
  static const InstructionTable table{
      {"dp4a", emit_dp4a}, {"dp2a", emit_dp2a}, {"bmsk", emit_bmsk}, {"szext", emit_szext}, {"fns", emit_fns},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
