#include "profiler/ptx/displacement.hpp"

namespace warpgrain::profiler::ptx {

bool takes_displacement(Emitter& e) { return e.modifiers().take("displaced"); }

llvm::Value* displaced(Emitter& e, llvm::Value* exact, const Displacement& bound) {
  llvm::Value* const bits = e.ir.CreateBitCast(exact, e.ir.getInt64Ty());
  // The finalizer of MurmurHash3 (A. Appleby, public domain): every bit of the operand moves every bit.
  llvm::Value* hash = bits;
  for (const std::uint64_t factor : {0xff51afd7ed558ccdULL, 0xc4ceb9fe1a85ec53ULL}) {
    hash = e.ir.CreateXor(hash, e.ir.CreateLShr(hash, 33));
    hash = e.ir.CreateMul(hash, e.ir.getInt64(factor));
  }
  hash = e.ir.CreateXor(hash, e.ir.CreateLShr(hash, 33));

  llvm::Type* const f64 = e.ir.getDoubleTy();
  const auto constant = [&](double value) { return llvm::ConstantFP::get(f64, value); };
  llvm::Value* share = e.ir.CreateFMul(e.ir.CreateSIToFP(hash, f64), constant(0x1p-63));
  // A unit in the last place is 2^-23 of what the result would be with the mantissa 1.
  constexpr std::uint64_t mantissa_bits = (std::uint64_t{1} << 52) - 1, one = std::uint64_t{0x3ff} << 52;
  llvm::Value* mantissa = e.ir.CreateBitCast(e.ir.CreateOr(e.ir.CreateAnd(bits, mantissa_bits), one), f64);
  llvm::Value* relative =
      e.ir.CreateFAdd(e.ir.CreateFDiv(constant(bound.ulps * 0x1p-23), mantissa), constant(bound.relative));
  llvm::Value* factor = e.ir.CreateFAdd(e.ir.CreateFMul(share, relative), constant(1.0));
  return e.ir.CreateFPTrunc(e.ir.CreateFMul(exact, factor), e.ir.getFloatTy());
}

}  // namespace warpgrain::profiler::ptx
