// Moves and conversions.

#include <fmt/format.h>

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

// mov.b64 %rd, {%r0, %r1}: the first element lies lowest.
Value* pack(Emitter& e, const Operand& vector, ScalarType type) {
  const auto width = static_cast<std::uint8_t>(type.bits / vector.elements.size());
  Value* packed = llvm::ConstantInt::get(e.int_type(type.bits), 0);
  for (std::size_t i = 0; i < vector.elements.size(); ++i) {
    Value* element = e.ir.CreateZExt(e.read(vector.elements[i], bits_type(width)), e.int_type(type.bits));
    packed = e.ir.CreateOr(packed, e.ir.CreateShl(element, i * width));
  }
  return packed;
}

void unpack(Emitter& e, const Operand& vector, Value* value, ScalarType type) {
  const auto width = static_cast<std::uint8_t>(type.bits / vector.elements.size());
  for (std::size_t i = 0; i < vector.elements.size(); ++i)
    e.write(vector.elements[i], e.ir.CreateTrunc(e.ir.CreateLShr(value, i * width), e.int_type(width)),
            bits_type(width));
}

void emit_mov(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::any);
  const Operand& to = e.operand(0);
  const Operand& from = e.operand(1);
  const bool packs = from.kind == Operand::Kind::vector;
  const bool unpacks = to.kind == Operand::Kind::vector;
  if (packs && unpacks) e.refuse("a register on one side");
  const std::size_t elements = packs ? from.elements.size() : unpacks ? to.elements.size() : 1;
  if (elements == 0 || type.bits % (8 * elements) != 0) {
    if (packs || unpacks) e.refuse("2 or 4 elements");
  }
  if (packs) return e.write(pack(e, from, type), bits_type(type.bits));
  if (unpacks) return unpack(e, to, e.read(from, bits_type(type.bits)), type);
  e.write(e.read(from, type), type);
}

// Every address is a host address, whatever its space.
void emit_cvta(Emitter& e) {
  e.modifiers().take("to");
  e.modifiers().take_space();
  const ScalarType type = e.take_type(Emitter::Types::integer);
  e.write(e.read(1, type), type);
}

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
  const bool from_float = from.is_float();
  const std::string_view source = from_float ? "f64" : from.is_signed() ? "s64" : "u64";
  if (to.bits == 16 || (from_float && (to.bits != 32 || from.bits != 64))) e.refuse("f32 or f64");
  if (!from_float)
    value = from.is_signed() ? e.ir.CreateSExt(value, e.ir.getInt64Ty())
                             : e.ir.CreateZExt(value, e.ir.getInt64Ty());
  return e.call_host(fmt::format("warpgrain_f{}_{}_{}", to.bits, rounding, source), e.type(to), {value});
}

void emit_cvt(Emitter& e) {
  const std::string_view rounding =
      e.modifiers().take_one_of({"rn", "rni", "rzi", "rmi", "rpi", "rz", "rm", "rp"});
  const bool is_directed = rounding == "rz" || rounding == "rm" || rounding == "rp";
  const bool flushes = e.modifiers().take("ftz");
  const bool saturates = e.modifiers().take("sat");
  const ScalarType to = e.take_type();
  const ScalarType from = e.take_type();
  Value* value = e.read(1, from);
  if (flushes && from == ScalarType{ScalarType::Kind::floating, 32}) value = flush_subnormal(e, value);
  if (is_directed) {
    if (!to.is_float() || saturates || flushes) e.refuse("a float, without .sat or .ftz");
    value = directed_to_float(e, value, from, to, rounding);
  } else if (from.is_float() && to.is_float()) {
    value = float_to_float(e, value, from, to, rounding);
    if (flushes && to.bits == 32) value = flush_subnormal(e, value);
    if (saturates) value = saturate(e, value);
  } else if (from.is_float()) {
    value = float_to_integer(e, value, to, rounding);
  } else if (to.is_float()) {
    value = from.is_signed() ? e.ir.CreateSIToFP(value, e.type(to)) : e.ir.CreateUIToFP(value, e.type(to));
  } else {
    value = saturates ? clamp_integer(e, value, from, to) : e.convert_bits(value, from, to);
  }
  e.write(value, to);
}

}  // namespace

const InstructionTable& move_instructions() {
  static const InstructionTable table{{"mov", emit_mov}, {"cvt", emit_cvt}, {"cvta", emit_cvta}};
  return table;
}

}  // namespace warpgrain::profiler::ptx
