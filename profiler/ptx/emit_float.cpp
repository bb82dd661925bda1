// Functions of one float. The `.approx` ones have error bounds of their own on every device; here they are
// evaluated correctly rounded, or nearly so, as PoCL does.

#include "profiler/ptx/displacement.hpp"
#include "profiler/ptx/float_operation.hpp"
#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

void take_accuracy(Emitter& e) { e.modifiers().take("approx"); }

// The rough forms of f64, .approx.ftz, see and give the upper words alone: 20 bits of mantissa.
Value* upper_word(Emitter& e, Value* value) {
  Value* bits = e.ir.CreateAnd(e.ir.CreateBitCast(value, e.ir.getInt64Ty()), ~std::uint64_t{0xffffffff});
  Value* exponent = e.ir.CreateAnd(bits, std::uint64_t{0x7ff} << 52);
  Value* is_small = e.ir.CreateICmpEQ(exponent, e.ir.getInt64(0));
  bits = e.ir.CreateSelect(is_small, e.ir.CreateAnd(bits, std::uint64_t{1} << 63), bits);
  return e.ir.CreateBitCast(bits, value->getType());
}

void emit_sqrt(Emitter& e) {
  FloatOperation modes(e, FloatOperation::Rounding::any);
  take_accuracy(e);
  const bool is_displaced = takes_displacement(e);
  const ScalarType type = e.take_type(Emitter::Types::floating);
  Value* x = modes.input(1, type);
  if (is_displaced) {
    llvm::Type* const f64 = e.ir.getDoubleTy();
    Value* root = e.call_intrinsic(llvm::Intrinsic::sqrt, f64, {e.ir.CreateFPExt(x, f64)});
    return modes.output(displaced(e, root, sqrt_displacement), type);
  }
  modes.output(modes.rounded("sqrt", {x}, e.call_intrinsic(llvm::Intrinsic::sqrt, e.type(type), {x})), type);
}

void emit_rcp(Emitter& e) {
  FloatOperation modes(e, FloatOperation::Rounding::any);
  take_accuracy(e);
  const bool is_displaced = takes_displacement(e);
  const ScalarType type = e.take_type(Emitter::Types::floating);
  const bool rough = modes.flushes() && type.bits == 64;
  Value* x = modes.input(1, type);
  if (is_displaced) {
    llvm::Type* const f64 = e.ir.getDoubleTy();
    Value* inverse = e.ir.CreateFDiv(llvm::ConstantFP::get(f64, 1.0), e.ir.CreateFPExt(x, f64));
    return modes.output(displaced(e, inverse, rcp_displacement), type);
  }
  if (rough) x = upper_word(e, x);
  Value* one = llvm::ConstantFP::get(e.type(type), 1.0);
  Value* result = modes.rounded("div", {one, x}, e.ir.CreateFDiv(one, x));
  modes.output(rough ? upper_word(e, result) : result, type);
}

void emit_rsqrt(Emitter& e) {
  FloatOperation modes(e);
  take_accuracy(e);
  const bool is_displaced = takes_displacement(e);
  const ScalarType type = e.take_type(Emitter::Types::floating);
  // In double, so that two roundings to float do not add up.
  llvm::Type* const f64 = e.ir.getDoubleTy();
  const bool rough = modes.flushes() && type.bits == 64;
  Value* x = e.ir.CreateFPExt(modes.input(1, type), f64);
  if (rough) x = upper_word(e, x);
  Value* root = e.call_intrinsic(llvm::Intrinsic::sqrt, f64, {x});
  Value* result = e.ir.CreateFDiv(llvm::ConstantFP::get(f64, 1.0), root);
  if (is_displaced) return modes.output(displaced(e, result, rsqrt_displacement), type);
  if (rough) result = upper_word(e, result);
  modes.output(e.ir.CreateFPTrunc(result, e.type(type)), type);
}

// sin.approx.f32 -> warpgrain_sin (host_functions.hpp), and so on.
void emit_host_function(Emitter& e) {
  FloatOperation modes(e);
  take_accuracy(e);
  const ScalarType type = e.take_type(Emitter::Types::floating);
  if (type.bits != 32) e.refuse("f32");
  modes.output(e.call_host("warpgrain_" + e.statement().opcode, e.type(type), {modes.input(1, type)}), type);
}

void emit_testp(Emitter& e) {
  const std::string_view test =
      e.modifiers().take_one_of({"finite", "infinite", "number", "notanumber", "normal", "subnormal"});
  const ScalarType type = e.take_type(Emitter::Types::floating);
  Value* magnitude = e.call_intrinsic(llvm::Intrinsic::fabs, e.type(type), {e.read(1, type)});
  Value* infinity = llvm::ConstantFP::getInfinity(e.type(type));
  Value* least_normal = llvm::ConstantFP::get(
      e.type(type), llvm::APFloat::getSmallestNormalized(e.type(type)->getFltSemantics()));
  Value* zero = llvm::ConstantFP::get(e.type(type), 0.0);
  Value* result = nullptr;
  if (test == "finite") result = e.ir.CreateFCmpOLT(magnitude, infinity);
  if (test == "infinite") result = e.ir.CreateFCmpOEQ(magnitude, infinity);
  if (test == "number") result = e.ir.CreateFCmpORD(magnitude, magnitude);
  if (test == "notanumber") result = e.ir.CreateFCmpUNO(magnitude, magnitude);
  if (test == "normal")
    result =
        e.ir.CreateAnd(e.ir.CreateFCmpOGE(magnitude, least_normal), e.ir.CreateFCmpOLT(magnitude, infinity));
  if (test == "subnormal")
    result = e.ir.CreateAnd(e.ir.CreateFCmpOLT(magnitude, least_normal), e.ir.CreateFCmpOGT(magnitude, zero));
  if (!result) e.refuse("a test");
  e.write(result, predicate_type);
}

// b with the sign of a
void emit_copysign(Emitter& e) {
  const ScalarType type = e.take_type(Emitter::Types::floating);
  Value* sign = e.read(1, type);
  e.write(e.call_intrinsic(llvm::Intrinsic::copysign, e.type(type), {e.read(2, type), sign}), type);
}

}  // namespace

const InstructionTable& float_instructions() {
  static const InstructionTable table{
      {"sqrt", emit_sqrt},         {"rcp", emit_rcp},
      {"rsqrt", emit_rsqrt},       {"sin", emit_host_function},
      {"cos", emit_host_function}, {"ex2", emit_host_function},
      {"lg2", emit_host_function}, {"tanh", emit_host_function},
      {"testp", emit_testp},       {"copysign", emit_copysign},
  };
  return table;
}

}  // namespace warpgrain::profiler::ptx
