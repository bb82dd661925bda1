#include "profiler/ptx/float_operation.hpp"

#include <fmt/format.h>

#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {

llvm::Value* flush_subnormal(Emitter& e, llvm::Value* value) {
  llvm::Value* bits = e.ir.CreateBitCast(value, e.ir.getInt32Ty());
  llvm::Value* is_small = e.ir.CreateICmpULT(e.ir.CreateAnd(bits, 0x7fffffff), e.ir.getInt32(0x00800000));
  llvm::Value* flushed = e.ir.CreateSelect(is_small, e.ir.CreateAnd(bits, 0x80000000), bits);
  return e.ir.CreateBitCast(flushed, value->getType());
}

llvm::Value* saturate(Emitter& e, llvm::Value* value) {
  llvm::Type* const type = value->getType();
  llvm::Value* zero = llvm::ConstantFP::get(type, 0.0);
  llvm::Value* one = llvm::ConstantFP::get(type, 1.0);
  // Ordered comparison: NaN goes to zero.
  llvm::Value* above_zero = e.ir.CreateSelect(e.ir.CreateFCmpOGT(value, zero), value, zero);
  return e.ir.CreateSelect(e.ir.CreateFCmpOLT(above_zero, one), above_zero, one);
}

FloatOperation::FloatOperation(Emitter& emitter, Rounding rounding)
    : emitter_(emitter),
      flushes_(emitter.modifiers().take("ftz")),
      saturates_(emitter.modifiers().take("sat")) {
  if (!emitter.modifiers().take("rn") && rounding == Rounding::any)
    rounding_ = emitter.modifiers().take_one_of({"rz", "rm", "rp"});
}

llvm::Value* FloatOperation::rounded(std::string_view operation, llvm::ArrayRef<llvm::Value*> inputs,
                                     llvm::Value* nearest) {
  if (rounding_.empty()) return nearest;
  llvm::Type* const type = nearest->getType();
  return emitter_.call_host(
      fmt::format("warpgrain_{}_{}_{}", operation, rounding_, type->isFloatTy() ? "f32" : "f64"), type,
      inputs);
}

llvm::Value* FloatOperation::input(std::size_t operand, ScalarType type) {
  if (!type.is_float() || type.bits == 16) emitter_.refuse("f32 or f64");
  llvm::Value* value = emitter_.read(operand, type);
  return flushes_ && type.bits == 32 ? flush_subnormal(emitter_, value) : value;
}

void FloatOperation::output(llvm::Value* value, ScalarType type) {
  if (flushes_ && type.bits == 32) value = flush_subnormal(emitter_, value);
  if (saturates_) value = saturate(emitter_, value);
  emitter_.write(value, type);
}

}  // namespace warpgrain::profiler::ptx
