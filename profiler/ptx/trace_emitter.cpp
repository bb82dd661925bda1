#include "profiler/ptx/trace_emitter.hpp"

#include <cstddef>

namespace warpgrain::profiler::ptx {

TraceEmitter::TraceEmitter(llvm::IRBuilder<>& ir, llvm::Value* lane_context, TraceMode mode)
    : ir_(ir), lane_context_(lane_context), mode_(mode) {
  if (mode_ == TraceMode::none) return;
  const auto load = [&](std::size_t offset) { return ir_.CreateLoad(ir_.getPtrTy(), field(offset)); };
  trace_ = ir_.CreateAlloca(ir_.getPtrTy());
  ir_.CreateStore(load(offsetof(LaneContext, trace)), trace_);
  trace_limit_ = load(offsetof(LaneContext, trace_limit));
  if (!records_addresses()) return;
  addresses_ = ir_.CreateAlloca(ir_.getPtrTy());
  ir_.CreateStore(load(offsetof(LaneContext, addresses)), addresses_);
  addresses_limit_ = load(offsetof(LaneContext, addresses_limit));
}

llvm::Value* TraceEmitter::field(std::size_t offset) {
  return ir_.CreateConstInBoundsGEP1_64(ir_.getInt8Ty(), lane_context_, offset);
}

llvm::Value* TraceEmitter::append(llvm::AllocaInst* cursor, llvm::Type* type, std::uint32_t count) {
  llvm::Value* here = ir_.CreateLoad(ir_.getPtrTy(), cursor);
  ir_.CreateStore(ir_.CreateConstInBoundsGEP1_64(type, here, count), cursor);
  return here;
}

void TraceEmitter::record_block(std::uint32_t block) {
  if (!trace_) return;
  llvm::Value* here = append(trace_, ir_.getInt16Ty(), 1);
  ir_.CreateStore(ir_.getInt16(static_cast<std::uint16_t>(block)), here);
}

void TraceEmitter::record_address(std::uint32_t slot, llvm::Value* address) {
  if (!addresses_) return;
  llvm::Value* here = ir_.CreateLoad(ir_.getPtrTy(), addresses_);
  ir_.CreateStore(address, ir_.CreateConstInBoundsGEP1_64(ir_.getInt64Ty(), here, slot));
}

void TraceEmitter::advance_addresses(std::uint32_t count) {
  if (addresses_ && count > 0) append(addresses_, ir_.getInt64Ty(), count);
}

llvm::Value* TraceEmitter::is_exhausted() {
  if (!trace_) return nullptr;
  llvm::Value* full = ir_.CreateICmpUGE(ir_.CreateLoad(ir_.getPtrTy(), trace_), trace_limit_);
  if (!addresses_) return full;
  return ir_.CreateOr(full, ir_.CreateICmpUGE(ir_.CreateLoad(ir_.getPtrTy(), addresses_), addresses_limit_));
}

void TraceEmitter::finish() {
  if (!trace_) return;
  llvm::Value* here = append(trace_, ir_.getInt16Ty(), 1);
  ir_.CreateStore(ir_.getInt16(trace_end), here);
  ir_.CreateStore(ir_.CreateLoad(ir_.getPtrTy(), trace_), field(offsetof(LaneContext, trace)));
  if (addresses_)
    ir_.CreateStore(ir_.CreateLoad(ir_.getPtrTy(), addresses_), field(offsetof(LaneContext, addresses)));
}

}  // namespace warpgrain::profiler::ptx
