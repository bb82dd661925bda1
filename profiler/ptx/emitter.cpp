#include "profiler/ptx/emitter.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {

Emitter::Emitter(llvm::IRBuilder<>& builder, llvm::Value* lane_context, const Module& module,
                 const Function& kernel, const MemoryLayout& layout, const Provenance* provenance,
                 TraceEmitter& trace, std::string_view where)
    : ir(builder),
      lane_context_(lane_context),
      module_(module),
      kernel_(kernel),
      layout_(layout),
      provenance_(provenance),
      trace_(trace),
      where_(where),
      entry_(builder.GetInsertBlock()) {
  for (const auto& [name, register_type] : kernel.registers) {
    llvm::AllocaInst* storage = ir.CreateAlloca(type(register_type));
    // PTX leaves a register undefined until it is written; zero makes a faulty kernel repeatable.
    ir.CreateStore(llvm::Constant::getNullValue(type(register_type)), storage);
    registers_.emplace(name, Register{storage, register_type});
  }
  for (const Variable& variable : kernel.variables) {
    if (variable.space == StateSpace::shared || variable.space == StateSpace::local) continue;
    if (variable.space != StateSpace::parameter)
      throw_input_error(place(where, variable.line), fmt::format("variable '{}' in a body", variable.name),
                        ".local, .shared or .param");
    llvm::AllocaInst* storage = ir.CreateAlloca(llvm::ArrayType::get(ir.getInt8Ty(), variable.bytes));
    storage->setAlignment(llvm::Align(std::max(variable.alignment, 1u)));
    memory_.emplace(variable.name, storage);
  }
  budget_ = ir.CreateAlloca(ir.getInt64Ty());
  ir.CreateStore(context_field(offsetof(LaneContext, budget), ir.getInt64Ty()), budget_);
  carry_ = ir.CreateAlloca(ir.getInt1Ty());
  ir.CreateStore(ir.getFalse(), carry_);
}

void Emitter::begin(const Statement& statement) {
  statement_ = &statement;
  modifiers_.emplace(statement);
  operands_used_ = 0;
}

void Emitter::end() {
  if (!modifiers_->left_over().empty()) refuse(fmt::format("it without '.{}'", modifiers_->left_over()));
}

void Emitter::refuse_surplus_operands() const {
  const auto& modifiers = statement_->modifiers;
  const bool has_policy =
      std::ranges::any_of(modifiers, [](const std::string& m) { return m.ends_with("::cache_hint"); });
  const std::size_t expected = operands_used_ + (has_policy ? 1 : 0);
  if (operand_count() > expected) refuse(fmt::format("{} operands", expected));
}

const Operand& Emitter::operand(std::size_t index) const {
  if (index >= statement_->operands.size()) refuse("more operands");
  operands_used_ = std::max(operands_used_, index + 1);
  return statement_->operands[index];
}

ScalarType Emitter::take_type(Types types) {
  const auto taken = modifiers_->take_type();
  if (!taken) {
    const std::string_view other = modifiers_->take_one_of(
        {"bf16", "bf16x2", "f16x2", "tf32", "e4m3", "e5m2", "e4m3x2", "e5m2x2", "u16x2", "s16x2", "b128"});
    refuse(other.empty() ? "a type" : fmt::format("a type other than '.{}'", other));
  }
  const bool fits = types == Types::any || (types == Types::number && !taken->is_predicate()) ||
                    (types == Types::floating && taken->is_float()) ||
                    (types == Types::integer && !taken->is_float() && !taken->is_predicate()) ||
                    (types == Types::integer_or_predicate && !taken->is_float());
  if (!fits)
    refuse(types == Types::floating ? "a float type"
           : types == Types::number ? "a number's type"
                                    : "an integer type");
  return *taken;
}

void Emitter::refuse(std::string_view expected) const {
  throw_input_error(place(where_, module_, *statement_),
                    fmt::format("instruction '{}' is not carried", statement_->text), expected);
}

llvm::Type* Emitter::type(ScalarType scalar) const {
  if (!scalar.is_float()) return int_type(scalar.bits);
  return scalar.bits == 16 ? ir.getHalfTy() : scalar.bits == 32 ? ir.getFloatTy() : ir.getDoubleTy();
}

llvm::Value* Emitter::convert_bits(llvm::Value* value, ScalarType from, ScalarType to) {
  if (type(from) == type(to)) return value;
  if (from.is_float()) value = ir.CreateBitCast(value, int_type(from.bits));
  value = from.is_signed() ? ir.CreateSExtOrTrunc(value, int_type(to.bits))
                           : ir.CreateZExtOrTrunc(value, int_type(to.bits));
  return to.is_float() ? ir.CreateBitCast(value, type(to)) : value;
}

llvm::Value* Emitter::read(const Operand& operand, ScalarType as) {
  switch (operand.kind) {
    case Operand::Kind::name: {
      if (operand.negated && !as.is_predicate()) refuse("'!' before predicates only");
      llvm::Value* value = read_name(operand, as);
      return operand.negated ? ir.CreateNot(value) : value;
    }
    case Operand::Kind::integer:
      if (as.is_predicate()) return ir.getInt1(operand.value != 0);
      return ir.CreateBitCast(llvm::ConstantInt::get(int_type(as.bits), operand.value), type(as));
    case Operand::Kind::float32: {
      const auto single = std::bit_cast<float>(static_cast<std::uint32_t>(operand.value));
      if (as == ScalarType{ScalarType::Kind::floating, 64}) return llvm::ConstantFP::get(type(as), single);
      return convert_bits(ir.getInt32(static_cast<std::uint32_t>(operand.value)), bits_type(32), as);
    }
    case Operand::Kind::float64: {
      if (as == ScalarType{ScalarType::Kind::floating, 32})
        return llvm::ConstantFP::get(type(as), static_cast<float>(std::bit_cast<double>(operand.value)));
      return convert_bits(ir.getInt64(operand.value), bits_type(64), as);
    }
    default:
      refuse("a register, a number or a symbol");
  }
}

llvm::Value* Emitter::read_name(const Operand& operand, ScalarType as) {
  if (const auto found = registers_.find(operand.name); found != registers_.end()) {
    const Register& r = found->second;
    return convert_bits(ir.CreateLoad(type(r.type), r.storage), r.type, as);
  }
  if (llvm::Value* special = special_register(operand.name))
    return convert_bits(special,
                        bits_type(static_cast<std::uint8_t>(special->getType()->getIntegerBitWidth())), as);
  if (llvm::Value* symbol = symbol_pointer(operand.name)) {
    llvm::Value* address = ir.CreatePtrToInt(symbol, ir.getInt64Ty());
    return convert_bits(ir.CreateAdd(address, ir.getInt64(operand.value)), bits_type(64), as);
  }
  if (const auto address = module_.function_address(operand.name))
    return convert_bits(ir.getInt64(*address), bits_type(64), as);
  throw_input_error(place(where_, module_, *statement_),
                    fmt::format("'{}' in '{}'", operand.name, statement_->text),
                    "a declared register, a known special register or a symbol of the module");
}

void Emitter::write(const Operand& operand, llvm::Value* value, ScalarType from) {
  if (operand.kind == Operand::Kind::name && operand.name == "_") return;
  const auto found = registers_.find(operand.name);
  if (operand.kind != Operand::Kind::name || found == registers_.end()) refuse("a register to write");
  ir.CreateStore(convert_bits(value, from, found->second.type), found->second.storage);
}

llvm::Value* Emitter::pointer(const Operand& operand) {
  if (operand.kind != Operand::Kind::address) refuse("an address");
  if (operand.name.empty()) return ir.CreateIntToPtr(ir.getInt64(operand.value), ir.getPtrTy());
  if (!registers_.count(operand.name))
    if (llvm::Value* symbol = symbol_pointer(operand.name))
      return operand.value == 0 ? symbol : ir.CreateConstGEP1_64(ir.getInt8Ty(), symbol, operand.value);
  Operand base;
  base.name = operand.name;
  llvm::Value* address = read_name(base, bits_type(64));
  if (operand.value != 0) address = ir.CreateAdd(address, ir.getInt64(operand.value));
  return ir.CreateIntToPtr(address, ir.getPtrTy());
}

llvm::Value* Emitter::context_pointer(std::size_t offset) {
  return ir.CreateConstInBoundsGEP1_64(ir.getInt8Ty(), lane_context_, offset);
}

llvm::Value* Emitter::context_field(std::size_t offset, llvm::Type* field_type) {
  llvm::LoadInst* load = ir.CreateLoad(field_type, context_pointer(offset));
  load->setMetadata(llvm::LLVMContext::MD_invariant_load, llvm::MDNode::get(ir.getContext(), {}));
  return load;
}

void Emitter::trace_access(llvm::Value* pointer) {
  if (trace_.records_addresses())
    trace_.record_address(access_slot, ir.CreatePtrToInt(pointer, ir.getInt64Ty()));
  ++access_slot;
}

llvm::AllocaInst* Emitter::scratch(llvm::Type* type) {
  llvm::IRBuilder<> at_entry(entry_, entry_->begin());
  return at_entry.CreateAlloca(type);
}

llvm::Value* Emitter::call_host(std::string_view name, llvm::Type* result,
                                llvm::ArrayRef<llvm::Value*> arguments) {
  std::vector<llvm::Type*> types;
  for (const llvm::Value* argument : arguments) types.push_back(argument->getType());
  llvm::Module* out = entry_->getModule();
  auto callee = out->getOrInsertFunction(llvm::StringRef(name.data(), name.size()),
                                         llvm::FunctionType::get(result, types, false));
  llvm::CallInst* call = ir.CreateCall(callee, arguments);
  call->setDoesNotThrow();
  return call;
}

llvm::Value* Emitter::spend(std::int64_t instructions) {
  llvm::Value* left = ir.CreateSub(ir.CreateLoad(ir.getInt64Ty(), budget_), ir.getInt64(instructions));
  ir.CreateStore(left, budget_);
  return left;
}

llvm::Value* Emitter::carry() { return ir.CreateLoad(ir.getInt1Ty(), carry_); }
void Emitter::set_carry(llvm::Value* value) { ir.CreateStore(value, carry_); }

}  // namespace warpgrain::profiler::ptx
