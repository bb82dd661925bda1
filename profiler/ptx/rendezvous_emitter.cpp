#include "profiler/ptx/rendezvous_emitter.hpp"

#include <cstddef>

#include "profiler/lane_context.hpp"

namespace warpgrain::profiler::ptx {
namespace {

// Instructions that a switch between lanes takes about as long as.
constexpr std::int64_t cost_of_waiting = 200;

llvm::Value* field(Emitter& e, std::size_t offset) {
  return e.context_pointer(offsetof(LaneContext, rendezvous) + offset);
}

void set(Emitter& e, std::size_t offset, llvm::Value* value, unsigned bits = 32) {
  value = value != nullptr ? e.ir.CreateZExtOrTrunc(value, e.int_type(bits))
                           : llvm::ConstantInt::get(e.int_type(bits), 0);
  e.ir.CreateStore(value, field(e, offset));
}

}  // namespace

void emit_rendezvous(Emitter& e, Meeting meeting, const RendezvousFields& fields) {
  set(e, offsetof(Rendezvous, meeting), e.ir.getInt32(static_cast<std::uint32_t>(meeting)));
  set(e, offsetof(Rendezvous, block), e.ir.getInt32(e.block));
  set(e, offsetof(Rendezvous, members), fields.members);
  set(e, offsetof(Rendezvous, has_members), e.ir.getInt32(fields.members != nullptr ? 1 : 0));
  set(e, offsetof(Rendezvous, index), fields.index);
  set(e, offsetof(Rendezvous, bound), fields.bound);
  set(e, offsetof(Rendezvous, aligned), e.ir.getInt32(fields.aligned ? 1 : 0));
  set(e, offsetof(Rendezvous, value), fields.value, 64);
  e.spend(cost_of_waiting);
  llvm::Value* wait = e.context_field(offsetof(LaneContext, wait), e.ir.getPtrTy());
  auto* type = llvm::FunctionType::get(e.ir.getVoidTy(), {e.ir.getPtrTy(), e.ir.getInt32Ty()}, false);
  e.ir.CreateCall(type, wait, {e.context_pointer(0), e.ir.getInt32(e.statement().line)});
}

llvm::Value* rendezvous_result(Emitter& e, llvm::IntegerType* type) {
  llvm::Value* result = e.ir.CreateLoad(e.ir.getInt64Ty(), field(e, offsetof(Rendezvous, result)));
  return e.ir.CreateTrunc(result, type);
}

llvm::Value* rendezvous_holds(Emitter& e) {
  llvm::Value* holds = e.ir.CreateLoad(e.ir.getInt32Ty(), field(e, offsetof(Rendezvous, holds)));
  return e.ir.CreateICmpNE(holds, e.ir.getInt32(0));
}

}  // namespace warpgrain::profiler::ptx
