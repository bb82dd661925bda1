#include "profiler/ptx/emit_printf.hpp"

#include <llvm/IR/Constants.h>
#include <llvm/IR/Instructions.h>
#include <vector>

namespace warpgrain::profiler::ptx {
namespace {

using llvm::Value;

// Instructions of a lane's budget, about as long as formatting takes.
constexpr std::int64_t cost_of_printing = 1000;

// The .param variable that a call names.
llvm::AllocaInst* call_variable(Emitter& e, const Operand& operand) {
  Operand address = operand;
  address.kind = Operand::Kind::address;
  auto* variable = llvm::dyn_cast<llvm::AllocaInst>(e.pointer(address));
  if (variable == nullptr) e.refuse("a .param variable for each argument");
  return variable;
}

std::uint32_t bytes_of(const llvm::AllocaInst* variable) {
  return static_cast<std::uint32_t>(variable->getAllocatedType()->getArrayNumElements());
}

Value* pointer_in(Emitter& e, const Operand& operand) {
  return e.ir.CreateLoad(e.ir.getPtrTy(), call_variable(e, operand));
}

// The places of the arguments, and their sizes, as two arrays.
std::pair<Value*, Value*> argument_arrays(Emitter& e, llvm::ArrayRef<Operand> arguments) {
  std::vector<std::uint32_t> sizes;
  llvm::AllocaInst* places = e.scratch(llvm::ArrayType::get(e.ir.getPtrTy(), arguments.size()));
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    llvm::AllocaInst* variable = call_variable(e, arguments[i]);
    sizes.push_back(bytes_of(variable));
    e.ir.CreateStore(variable, e.ir.CreateConstGEP1_64(e.ir.getPtrTy(), places, i));
  }
  llvm::Constant* values = llvm::ConstantDataArray::get(e.ir.getContext(), sizes);
  auto* sizes_variable =
      new llvm::GlobalVariable(*e.ir.GetInsertBlock()->getModule(), values->getType(), true,
                               llvm::GlobalValue::PrivateLinkage, values, "printf.sizes");
  return {places, sizes_variable};
}

}  // namespace

bool is_printf(std::string_view callee) { return callee == "printf" || callee == "vprintf"; }

void emit_printf(Emitter& e) {
  e.modifiers().take("uni");
  e.spend(cost_of_printing);
  const std::vector<Operand>& operands = e.statement().operands;
  const bool has_result = operands.front().kind == Operand::Kind::list;
  const Operand& callee = e.operand(has_result ? 1 : 0);
  const Operand& list = e.operand(has_result ? 2 : 1);
  const llvm::ArrayRef<Operand> arguments(list.elements);
  Value* result = nullptr;
  if (callee.name == "vprintf") {
    if (arguments.size() != 2) e.refuse("vprintf, (format, arguments)");
    Value* format = pointer_in(e, arguments[0]);
    result = e.call_host("warpgrain_vprintf", e.ir.getInt32Ty(),
                         {e.context_pointer(0), format, pointer_in(e, arguments[1])});
  } else {
    if (arguments.empty()) e.refuse("a format");
    Value* format = pointer_in(e, arguments[0]);
    const auto [places, sizes] = argument_arrays(e, arguments.drop_front());
    result = e.call_host("warpgrain_printf", e.ir.getInt32Ty(),
                         {e.context_pointer(0), format, places, sizes,
                          e.ir.getInt32(static_cast<std::uint32_t>(arguments.size() - 1))});
  }
  if (has_result && !operands.front().elements.empty())
    e.ir.CreateStore(result, call_variable(e, operands.front().elements[0]));
}

}  // namespace warpgrain::profiler::ptx
