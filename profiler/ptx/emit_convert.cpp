// Conversions between numbers.

#include <fmt/format.h>

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

// An integral float nearest to the value, by the rounding's name; null: it names none.
Value* round_to_integral(Emitter& e, Value* value, std::string_view rounding) {
  const auto call = [&](llvm::Intrinsic::ID id) { return e.call_intrinsic(id, value->getType(), {value}); };
  if (rounding == "rni") return call(llvm::Intrinsic::roundeven);
  if (rounding == "rzi") return call(llvm::Intrinsic::trunc);
  if (rounding == "rmi") return call(llvm::Intrinsic::floor);
  if (rounding == "rpi") return call(llvm::Intrinsic::ceil);
  return nullptr;
}

Value* float_to_float(Emitter& e, Value* value, ScalarType from, ScalarType to, std::string_view rounding) {
  if (Value* integral = round_to_integral(e, value, rounding)) value = integral;
  if (to.bits > from.bits) return e.ir.CreateFPExt(value, e.type(to));
  if (to.bits < from.bits) return e.ir.CreateFPTrunc(value, e.type(to));
  return value;
}

// Values beyond the integer's range go to its end, NaN to zero.
Value* float_to_integer(Emitter& e, Value* value, ScalarType to, std::string_view rounding) {
  Value* integral = round_to_integral(e, value, rounding);
  if (!integral) e.refuse(".rni, .rzi, .rmi or .rpi");
  const auto id = to.is_signed() ? llvm::Intrinsic::fptosi_sat : llvm::Intrinsic::fptoui_sat;
  return e.ir.CreateIntrinsic(id, {e.type(to), value->getType()}, {integral});
}

// Between integers, to the range of `to`.
Value* clamp_integer(Emitter& e, Value* value, ScalarType from, ScalarType to) {
  // One bit more than either holds every value of both.
  const unsigned bits = std::max(from.bits, to.bits) + 1u;
  const auto limit = [&](const llvm::APInt& end) {
    return llvm::ConstantInt::get(e.int_type(bits), to.is_signed() ? end.sext(bits) : end.zext(bits));
  };
  llvm::Type* const wide = e.int_type(bits);
  value = from.is_signed() ? e.ir.CreateSExt(value, wide) : e.ir.CreateZExt(value, wide);
  Value* least =
      limit(to.is_signed() ? llvm::APInt::getSignedMinValue(to.bits) : llvm::APInt::getMinValue(to.bits));
  Value* most =
      limit(to.is_signed() ? llvm::APInt::getSignedMaxValue(to.bits) : llvm::APInt::getMaxValue(to.bits));
  value = e.ir.CreateSelect(e.ir.CreateICmpSLT(value, least), least, value);
  value = e.ir.CreateSelect(e.ir.CreateICmpSGT(value, most), most, value);
  return e.ir.CreateTrunc(value, e.int_type(to.bits));
}

// To a float that cannot hold every value, towards zero, down or up.
Value* directed_to_float(Emitter& e, Value* value, ScalarType from, ScalarType to,
                         std::string_view rounding) {
  if (from.is_float() && from.bits <= to.bits) e.refuse("a narrower float");
  const auto call = [&](unsigned to_bits, std::string_view source, llvm::Type* result) {
    return e.call_host(fmt::format("warpgrain_f{}_{}_{}", to_bits, rounding, source), result, {value});
  };
  if (!from.is_float())
    value = from.is_signed() ? e.ir.CreateSExt(value, e.ir.getInt64Ty())
                             : e.ir.CreateZExt(value, e.ir.getInt64Ty());
  const std::string_view source = from.is_float() ? "f64" : from.is_signed() ? "s64" : "u64";
  if (to.bits > 16) return call(to.bits, source, e.type(to));
  // By way of f64: two roundings in one direction are one.
  value =
      from.is_float() ? e.ir.CreateFPExt(value, e.ir.getDoubleTy()) : call(64, source, e.ir.getDoubleTy());
  return e.ir.CreateBitCast(call(16, "f64", e.ir.getInt16Ty()), e.type(to));
}

Value* to_float(Emitter& e, Value* value, ScalarType from, ScalarType to, std::string_view rounding) {
  if (rounding == "rz" || rounding == "rm" || rounding == "rp")
    return directed_to_float(e, value, from, to, rounding);
  if (from.is_float()) return float_to_float(e, value, from, to, rounding);
  return from.is_signed() ? e.ir.CreateSIToFP(value, e.type(to)) : e.ir.CreateUIToFP(value, e.type(to));
}

// cvt.pack.sat.u8.s32.b32 d, a, b, c: a above b, both cut to the range; bytes above the low half of c.
void emit_pack(Emitter& e) {
  if (!e.modifiers().take("sat")) e.refuse(".sat");
  const ScalarType to = e.take_type(Emitter::Types::integer);
  const ScalarType from = e.take_type(Emitter::Types::integer);
  const bool appends = e.modifiers().take("b32");
  if (from.bits != 32 || !from.is_signed() || to.bits > 16 || appends != (to.bits == 8))
    e.refuse(".u16 or .s16 of s32, or .u8 or .s8 of s32 with .b32");
  const auto cut = [&](std::size_t operand) {
    return e.ir.CreateZExt(clamp_integer(e, e.read(operand, from), from, to), e.ir.getInt32Ty());
  };
  Value* result = e.ir.CreateOr(e.ir.CreateShl(cut(1), to.bits), cut(2));
  if (appends) result = e.ir.CreateOr(e.ir.CreateShl(e.read(3, bits_type(32)), 16), result);
  e.write(result, bits_type(32));
}

void emit_cvt(Emitter& e) {
  if (e.modifiers().take("pack")) return emit_pack(e);
  const std::string_view rounding =
      e.modifiers().take_one_of({"rn", "rni", "rzi", "rmi", "rpi", "rz", "rm", "rp"});
  const bool flushes = e.modifiers().take("ftz");
  const bool saturates = e.modifiers().take("sat");
  const ScalarType to = e.take_type();
  const ScalarType from = e.take_type();
  Value* value = e.read(1, from);
  if (flushes && from == ScalarType{ScalarType::Kind::floating, 32}) value = flush_subnormal(e, value);
  if (to.is_float()) {
    value = to_float(e, value, from, to, rounding);
    if (flushes && to.bits == 32) value = flush_subnormal(e, value);
    if (saturates) value = saturate(e, value);
  } else if (from.is_float()) {
    value = float_to_integer(e, value, to, rounding);
  } else {
    value = saturates ? clamp_integer(e, value, from, to) : e.convert_bits(value, from, to);
  }
  e.write(value, to);
}

}  // namespace

const InstructionTable& convert_instructions() {
  static const InstructionTable table{{"cvt", emit_cvt}};
  return table;
}

}  // namespace warpgrain::profiler::ptx
