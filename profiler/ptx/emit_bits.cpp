// Logic, shifts and bit fields.

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

void emit_and(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer_or_predicate);
  Value* a = e.read(1, type);
  e.write(e.ir.CreateAnd(a, e.read(2, type)), type);
}

void emit_or(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer_or_predicate);
  Value* a = e.read(1, type);
  e.write(e.ir.CreateOr(a, e.read(2, type)), type);
}

void emit_xor(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer_or_predicate);
  Value* a = e.read(1, type);
  e.write(e.ir.CreateXor(a, e.read(2, type)), type);
}

void emit_not(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer_or_predicate);
  e.write(e.ir.CreateNot(e.read(1, type)), type);
}

// 1 for zero, else 0
void emit_cnot(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* is_zero = e.ir.CreateICmpEQ(e.read(1, type), llvm::ConstantInt::get(e.type(type), 0));
  e.write(e.ir.CreateZExt(is_zero, e.type(type)), type);
}

// Any function of three bits: the constant's bit 4a + 2b + c is its value.
void emit_lop3(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (e.operand_count() != 5 || e.operand(4).kind != Operand::Kind::integer) e.refuse("a constant table");
  Value* const inputs[] = {e.read(1, type), e.read(2, type), e.read(3, type)};
  Value* result = llvm::ConstantInt::get(e.type(type), 0);
  for (unsigned row = 0; row < 8; ++row) {
    if (!(e.operand(4).value >> row & 1)) continue;
    Value* term = llvm::ConstantInt::getAllOnesValue(e.type(type));
    for (unsigned i = 0; i < 3; ++i)
      term = e.ir.CreateAnd(term, row >> (2 - i) & 1 ? inputs[i] : e.ir.CreateNot(inputs[i]));
    result = e.ir.CreateOr(result, term);
  }
  e.write(result, type);
}

// Amounts of the width and more are clamped to it, where LLVM's shifts are undefined.
Value* shift_left(Emitter& e, Value* value, Value* amount) {
  llvm::Type* const type = value->getType();
  Value* fits = e.ir.CreateICmpULT(amount, llvm::ConstantInt::get(type, type->getIntegerBitWidth()));
  Value* safe = e.ir.CreateSelect(fits, amount, llvm::ConstantInt::get(type, 0));
  return e.ir.CreateSelect(fits, e.ir.CreateShl(value, safe), llvm::ConstantInt::get(type, 0));
}

Value* shift_right(Emitter& e, Value* value, Value* amount, bool arithmetic) {
  llvm::Type* const type = value->getType();
  const unsigned width = type->getIntegerBitWidth();
  Value* fits = e.ir.CreateICmpULT(amount, llvm::ConstantInt::get(type, width));
  Value* safe = e.ir.CreateSelect(fits, amount, llvm::ConstantInt::get(type, width - 1));
  if (arithmetic) return e.ir.CreateAShr(value, safe);
  return e.ir.CreateSelect(fits, e.ir.CreateLShr(value, safe), llvm::ConstantInt::get(type, 0));
}

// The amount is 32 bits wide whatever is shifted.
Value* shift_amount(Emitter& e, std::size_t index, ScalarType type) {
  Value* amount = e.read(index, {ScalarType::Kind::unsigned_integer, 32});
  if (type.bits >= 32) return e.ir.CreateZExt(amount, e.int_type(type.bits));
  // Cutting a large amount to 16 bits could make it small.
  return e.ir.CreateTrunc(
      e.call_intrinsic(llvm::Intrinsic::umin, e.ir.getInt32Ty(), {amount, e.ir.getInt32(type.bits)}),
      e.int_type(type.bits));
}

void emit_shl(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* value = e.read(1, type);
  e.write(shift_left(e, value, shift_amount(e, 2, type)), type);
}

void emit_shr(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* value = e.read(1, type);
  e.write(shift_right(e, value, shift_amount(e, 2, type), type.is_signed()), type);
}

// shf.l: the high word of {b, a} << c; shf.r: the low word of {b, a} >> c.
void emit_shf(Emitter& e) {
  const bool left = e.modifiers().take_one_of({"l", "r"}) == "l";
  const bool wraps = e.modifiers().take_one_of({"wrap", "clamp"}) == "wrap";
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (type.bits != 32) e.refuse("b32");
  const auto widen = [&](Value* v) { return e.ir.CreateZExt(v, e.ir.getInt64Ty()); };
  Value* low = widen(e.read(1, type));
  Value* pair = e.ir.CreateOr(e.ir.CreateShl(widen(e.read(2, type)), 32), low);
  Value* amount = e.read(3, type);
  amount = wraps ? e.ir.CreateAnd(amount, 31)
                 : e.call_intrinsic(llvm::Intrinsic::umin, e.ir.getInt32Ty(), {amount, e.ir.getInt32(32)});
  Value* shifted =
      left ? e.ir.CreateLShr(e.ir.CreateShl(pair, widen(amount)), 32) : e.ir.CreateLShr(pair, widen(amount));
  e.write(e.ir.CreateTrunc(shifted, e.ir.getInt32Ty()), type);
}

// Position and length of a bit field: the low bytes of the operands.
Value* field_operand(Emitter& e, std::size_t index, ScalarType type) {
  Value* value = e.ir.CreateAnd(e.read(index, bits_type(32)), 255);
  return e.ir.CreateZExtOrTrunc(value, e.type(type));
}

// `length` low ones
Value* low_ones(Emitter& e, Value* length) {
  llvm::Type* const type = length->getType();
  Value* power = shift_left(e, llvm::ConstantInt::get(type, 1), length);
  return e.ir.CreateSub(power, llvm::ConstantInt::get(type, 1));  // of the full width: 0 - 1
}

void emit_bfe(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* position = field_operand(e, 2, type);
  Value* length = field_operand(e, 3, type);
  Value* shifted = shift_right(e, e.read(1, type), position, type.is_signed());
  if (!type.is_signed()) return e.write(e.ir.CreateAnd(shifted, low_ones(e, length)), type);
  Value* width = llvm::ConstantInt::get(e.type(type), type.bits);
  Value* zero = llvm::ConstantInt::get(e.type(type), 0);
  // The field is moved to the top and back, which repeats its highest bit; nothing to move where it fills the
  // word.
  Value* spare = e.ir.CreateSelect(e.ir.CreateICmpULT(length, width), e.ir.CreateSub(width, length), zero);
  Value* result = shift_right(e, shift_left(e, shifted, spare), spare, true);
  e.write(e.ir.CreateSelect(e.ir.CreateICmpEQ(length, zero), zero, result), type);
}

void emit_bfi(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* field = e.read(1, type);
  Value* base = e.read(2, type);
  Value* position = field_operand(e, 3, type);
  Value* mask = shift_left(e, low_ones(e, field_operand(e, 4, type)), position);
  Value* inserted = e.ir.CreateAnd(shift_left(e, field, position), mask);
  e.write(e.ir.CreateOr(e.ir.CreateAnd(base, e.ir.CreateNot(mask)), inserted), type);
}

const ScalarType word{ScalarType::Kind::unsigned_integer, 32};

void emit_popc(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* count = e.call_intrinsic(llvm::Intrinsic::ctpop, e.type(type), {e.read(1, type)});
  e.write(e.ir.CreateZExtOrTrunc(count, e.ir.getInt32Ty()), word);
}

Value* leading_zeros(Emitter& e, Value* value) {
  Value* count = e.ir.CreateIntrinsic(llvm::Intrinsic::ctlz, {value->getType()}, {value, e.ir.getFalse()});
  return e.ir.CreateZExtOrTrunc(count, e.ir.getInt32Ty());
}

void emit_clz(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(leading_zeros(e, e.read(1, type)), word);
}

// The highest bit that is not the sign; all ones when there is none. .shiftamt counts from the top.
void emit_bfind(Emitter& e) {
  const bool from_top = e.modifiers().take("shiftamt");
  const ScalarType type = e.take_type(Emitter::Types::integer);
  Value* value = e.read(1, type);
  Value* zero = llvm::ConstantInt::get(e.type(type), 0);
  if (type.is_signed())
    value = e.ir.CreateSelect(e.ir.CreateICmpSLT(value, zero), e.ir.CreateNot(value), value);
  Value* zeros = leading_zeros(e, value);
  Value* found = from_top ? zeros : e.ir.CreateSub(e.ir.getInt32(type.bits - 1u), zeros);
  e.write(e.ir.CreateSelect(e.ir.CreateICmpEQ(value, zero), e.ir.getInt32(~0u), found), word);
}

void emit_brev(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(e.call_intrinsic(llvm::Intrinsic::bitreverse, e.type(type), {e.read(1, type)}), type);
}

// The modes of prmt as nibbles for its plain form, a row of 16 bits for each value of c's low two bits.
std::optional<std::uint64_t> permutation_mode(std::string_view mode) {
  static const std::unordered_map<std::string_view, std::uint64_t> modes{
      {"f4e", 0x6543'5432'4321'3210}, {"b4e", 0x0123'7012'6701'5670}, {"rc8", 0x3333'2222'1111'0000},
      {"ecl", 0x3333'3222'3211'3210}, {"ecr", 0x3210'2210'1110'0000}, {"rc16", 0x3232'1010'3232'1010}};
  const auto found = modes.find(mode);
  return found == modes.end() ? std::nullopt : std::optional(found->second);
}

// Byte i of the result is byte n of {b, a}, where n is nibble i of c; the nibble's top bit repeats that
// byte's sign.
void emit_prmt(Emitter& e) {
  const auto mode = permutation_mode(e.modifiers().take_one_of({"f4e", "b4e", "rc8", "ecl", "ecr", "rc16"}));
  const ScalarType type = e.take_type(Emitter::Types::integer);
  if (type.bits != 32) e.refuse("b32");
  const auto widen = [&](Value* v) { return e.ir.CreateZExt(v, e.ir.getInt64Ty()); };
  Value* low = widen(e.read(1, type));
  Value* bytes = e.ir.CreateOr(e.ir.CreateShl(widen(e.read(2, type)), 32), low);
  Value* selector = e.read(3, type);
  if (mode) {
    Value* row = e.ir.CreateLShr(e.ir.getInt64(*mode), widen(e.ir.CreateShl(e.ir.CreateAnd(selector, 3), 4)));
    selector = e.ir.CreateTrunc(row, e.ir.getInt32Ty());
  }
  Value* result = e.ir.getInt32(0);
  for (unsigned i = 0; i < 4; ++i) {
    Value* nibble = e.ir.CreateLShr(selector, i * 4);
    Value* shift = widen(e.ir.CreateShl(e.ir.CreateAnd(nibble, 7), 3));
    Value* byte = e.ir.CreateTrunc(e.ir.CreateLShr(bytes, shift), e.ir.getInt8Ty());
    Value* sign = e.ir.CreateAShr(byte, 7);
    Value* repeats = e.ir.CreateICmpNE(e.ir.CreateAnd(nibble, 8), e.ir.getInt32(0));
    byte = e.ir.CreateSelect(repeats, sign, byte);
    result = e.ir.CreateOr(result, e.ir.CreateShl(e.ir.CreateZExt(byte, e.ir.getInt32Ty()), i * 8));
  }
  e.write(result, type);
}

}  // namespace

const InstructionTable& bit_instructions() {
  static const InstructionTable table{
      {"and", emit_and},   {"or", emit_or},       {"xor", emit_xor},   {"not", emit_not},
      {"cnot", emit_cnot}, {"lop3", emit_lop3},   {"shl", emit_shl},   {"shr", emit_shr},
      {"shf", emit_shf},   {"bfe", emit_bfe},     {"bfi", emit_bfi},   {"popc", emit_popc},
      {"clz", emit_clz},   {"bfind", emit_bfind}, {"brev", emit_brev}, {"prmt", emit_prmt},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
