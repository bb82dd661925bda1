// Checks of memory accesses: a short comparison in line, and a call where that does not hold.

#include <bit>
#include <cstddef>
#include <fmt/format.h>
#include <llvm/IR/MDBuilder.h>

#include "core/error.hpp"
#include "profiler/ptx/emitter.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {

// Whether a variable named in the operand holds the access, as far as that shows without running.
bool Emitter::fits_symbol(const Operand& operand, const AccessSite& site) const {
  if (operand.name.empty() || registers_.contains(operand.name) || site.object == AccessSite::any_object)
    return false;
  const MemoryObject& object = provenance_->objects()[site.object];
  const bool may_be = site.kind == AccessKind::load || !object.read_only;
  return may_be && operand.value + site.bytes <= object.bytes && operand.value <= object.bytes &&
         operand.value % site.bytes == 0;
}

// One comparison says that the access begins on a multiple of its size and ends in the object: rotating
// right brings the low bits of a misaligned offset to the top, where they make it too large.
llvm::Value* Emitter::in_bounds(llvm::Value* address, const AccessSite& site) {
  llvm::Type* const u64 = ir.getInt64Ty();
  llvm::Value *begin, *count;
  const bool is_local = site.object != AccessSite::any_object &&
                        provenance_->objects()[site.object].kind == MemoryObject::Kind::local;
  if (is_local) {
    const MemoryObject& object = provenance_->objects()[site.object];
    begin = ir.CreateAdd(context_field(offsetof(LaneContext, local), u64), ir.getInt64(object.offset));
    count = ir.getInt64(object.bytes / site.bytes);
  } else {
    llvm::Value* bounds = context_field(offsetof(LaneContext, bounds), ir.getPtrTy());
    const auto field = [&](std::size_t offset) {
      return ir.CreateLoad(u64, ir.CreateConstInBoundsGEP1_64(ir.getInt8Ty(), bounds,
                                                              sites.size() * sizeof(SiteBounds) + offset));
    };
    begin = field(offsetof(SiteBounds, begin));
    count = field(offsetof(SiteBounds, count));
  }
  llvm::Value* offset = ir.CreateSub(address, begin);
  if (site.bytes > 1)
    offset = ir.CreateIntrinsic(llvm::Intrinsic::fshr, {u64},
                                {offset, offset, ir.getInt64(std::countr_zero(unsigned{site.bytes}))});
  return ir.CreateICmpULT(offset, count);
}

llvm::Value* Emitter::checked(llvm::Value* pointer, const Operand& operand, AccessSite site,
                              llvm::ArrayRef<llvm::Value*> stored) {
  if (site.space == AccessSpace::parameter && !operand.name.empty() && !registers_.contains(operand.name)) {
    refuse_beyond_parameter(operand, site.bytes);
    return pointer;
  }
  if (!provenance_) return pointer;
  site.line = statement_->line;
  site.object = provenance_->object_of(operand);
  // What other work-items see is looked at for races, even where it fits.
  if (site.space != AccessSpace::shared && site.space != AccessSpace::global && fits_symbol(operand, site))
    return pointer;

  llvm::Function* const lane = entry_->getParent();
  llvm::BasicBlock* look = llvm::BasicBlock::Create(ir.getContext(), "look_closer", lane);
  llvm::BasicBlock* access = llvm::BasicBlock::Create(ir.getContext(), "access", lane);
  llvm::Value* address = ir.CreatePtrToInt(pointer, ir.getInt64Ty());
  llvm::BasicBlock* start;
  {
    llvm::Value* fits = in_bounds(address, site);
    start = ir.GetInsertBlock();
    ir.CreateCondBr(fits, access, look, llvm::MDBuilder(ir.getContext()).createBranchWeights(1000, 1));
  }
  ir.SetInsertPoint(look);
  for (std::size_t i = 0; i < stored.size(); ++i)
    ir.CreateStore(stored[i], context_pointer(offsetof(LaneContext, stored) + i * site.element_bytes));
  auto* type =
      llvm::FunctionType::get(ir.getPtrTy(), {ir.getPtrTy(), ir.getInt32Ty(), ir.getInt64Ty()}, false);
  llvm::CallInst* other =
      ir.CreateCall(type, context_field(offsetof(LaneContext, look_closer), ir.getPtrTy()),
                    {lane_context_, ir.getInt32(static_cast<std::uint32_t>(sites.size())), address});
  other->setDoesNotThrow();
  ir.CreateBr(access);
  ir.SetInsertPoint(access);
  llvm::PHINode* where = ir.CreatePHI(ir.getPtrTy(), 2);
  where->addIncoming(pointer, start);
  where->addIncoming(other, look);
  sites.push_back(site);
  return where;
}

// Parameters are named with constant offsets, of which PTX allows none beyond them.
void Emitter::refuse_beyond_parameter(const Operand& operand, std::uint32_t bytes) const {
  const auto refuse_beyond = [&](const Variable& variable) {
    if (variable.name == operand.name &&
        (operand.value > variable.bytes || operand.value + bytes > variable.bytes))
      throw_input_error(place(where_, module_, *statement_), fmt::format("'{}'", statement_->text),
                        fmt::format("an access within the {} bytes of '{}'", variable.bytes, variable.name));
  };
  for (const Variable& parameter : kernel_.parameters) refuse_beyond(parameter);
  for (const Variable& variable : kernel_.variables) refuse_beyond(variable);
}

void Emitter::list_variables(llvm::StringRef name) {
  std::vector<llvm::Constant*> addresses;
  for (const Variable* variable : provenance_->variables()) {
    const auto found = globals_.find(variable->name);
    addresses.push_back(found == globals_.end() ? llvm::ConstantPointerNull::get(ir.getPtrTy())
                                                : static_cast<llvm::Constant*>(found->second));
  }
  addresses.push_back(llvm::ConstantPointerNull::get(ir.getPtrTy()));  // arrays have at least one element
  auto* type = llvm::ArrayType::get(ir.getPtrTy(), addresses.size());
  new llvm::GlobalVariable(*entry_->getModule(), type, true, llvm::GlobalValue::ExternalLinkage,
                           llvm::ConstantArray::get(type, addresses), name);
}

}  // namespace warpgrain::profiler::ptx
