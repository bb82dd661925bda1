// Names that an operand may use beside registers: special registers, parameters, and variables of every
// space.

#include <cstddef>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/emitter.hpp"
#include "profiler/ptx/place.hpp"

namespace warpgrain::profiler::ptx {

llvm::Value* Emitter::special_register(const std::string& name) {
  llvm::Type* const u32 = ir.getInt32Ty();
  const auto component = [&](std::string_view prefix, std::size_t offset) -> llvm::Value* {
    if (name.size() != prefix.size() + 2 || !name.starts_with(prefix) || name[prefix.size()] != '.')
      return nullptr;
    const char axis = name.back();
    if (axis < 'x' || axis > 'z') return nullptr;
    return context_field(offset + static_cast<std::size_t>(axis - 'x') * sizeof(std::uint32_t), u32);
  };
  if (!name.starts_with('%')) return name == "WARP_SZ" ? ir.getInt32(32) : nullptr;
  if (auto* value = component("%tid", offsetof(LaneContext, tid))) return value;
  if (auto* value = component("%ntid", offsetof(LaneContext, ntid))) return value;
  if (auto* value = component("%ctaid", offsetof(LaneContext, ctaid))) return value;
  if (auto* value = component("%nctaid", offsetof(LaneContext, nctaid))) return value;
  // The driver's own. OpenCL's offsets are among them, and launches have none; opencl_prelude.cl reads the
  // global size in the last.
  for (std::size_t d = 0; d < 3; ++d)
    if (name == global_size_registers[d])
      return context_field(offsetof(LaneContext, global_size) + d * sizeof(std::uint32_t), u32);
  if (name.starts_with("%envreg")) return ir.getInt32(0);

  const auto linear = [&] { return context_field(offsetof(LaneContext, linear_tid), u32); };
  const auto lane = [&] { return ir.CreateAnd(linear(), 31); };
  const auto bit = [&] { return ir.CreateShl(ir.getInt32(1), lane()); };
  if (name == "%laneid") return lane();
  if (name == "%warpid") return ir.CreateLShr(linear(), 5);
  if (name == "%nwarpid")
    return ir.CreateLShr(
        ir.CreateAdd(context_field(offsetof(LaneContext, work_group_size), u32), ir.getInt32(31)), 5);
  if (name == "%lanemask_eq") return bit();
  if (name == "%lanemask_lt") return ir.CreateSub(bit(), ir.getInt32(1));
  if (name == "%lanemask_ge") return ir.CreateNeg(bit());
  if (name == "%lanemask_le") return ir.CreateOr(bit(), ir.CreateSub(bit(), ir.getInt32(1)));
  if (name == "%clock") return ir.CreateTrunc(read_clock(), u32);
  if (name == "%clock_hi") return ir.CreateTrunc(ir.CreateLShr(read_clock(), 32), u32);
  if (name == "%clock64" || name == "%globaltimer") return read_clock();
  if (name == "%globaltimer_lo") return ir.CreateTrunc(read_clock(), u32);
  if (name == "%globaltimer_hi") return ir.CreateTrunc(ir.CreateLShr(read_clock(), 32), u32);
  // One multiprocessor, and one grid at a time.
  if (name == "%smid") return ir.getInt32(0);
  if (name == "%nsmid") return ir.getInt32(1);
  if (name == "%gridid") return ir.getInt64(0);
  if (name == "%lanemask_gt") return ir.CreateNot(ir.CreateOr(bit(), ir.CreateSub(bit(), ir.getInt32(1))));
  return nullptr;
}

// No time passes in the simulator: each reading is a hundred cycles behind the lane's last one, so that loops
// that wait for time end and results can be repeated.
llvm::Value* Emitter::read_clock() {
  llvm::Value* field = context_pointer(offsetof(LaneContext, clock));
  llvm::Value* now = ir.CreateAdd(ir.CreateLoad(ir.getInt64Ty(), field), ir.getInt64(100));
  ir.CreateStore(now, field);
  return now;
}

llvm::Value* Emitter::lies_in(StateSpace space, llvm::Value* address) {
  const auto within = [&](llvm::Value* begin, llvm::Value* bytes) {
    llvm::Value* offset = ir.CreateSub(address, ir.CreatePtrToInt(begin, ir.getInt64Ty()));
    return ir.CreateICmpULT(offset, ir.CreateZExt(bytes, ir.getInt64Ty()));
  };
  llvm::Value* found = ir.getFalse();
  switch (space) {
    case StateSpace::shared:
      return within(context_field(offsetof(LaneContext, shared), ir.getPtrTy()),
                    context_field(offsetof(LaneContext, shared_bytes), ir.getInt32Ty()));
    case StateSpace::parameter:
      return within(context_field(offsetof(LaneContext, parameters), ir.getPtrTy()),
                    ir.getInt32(layout_.parameter_bytes));
    case StateSpace::local:
      return within(context_field(offsetof(LaneContext, local), ir.getPtrTy()),
                    ir.getInt32(layout_.local_bytes));
    case StateSpace::constant:
      for (const Variable& variable : module_.variables)
        if (variable.space == StateSpace::constant && !variable.external)
          found = ir.CreateOr(found, within(module_variable(variable), ir.getInt64(variable.bytes)));
      return found;
    default:
      for (const StateSpace other : {StateSpace::shared, StateSpace::local, StateSpace::parameter})
        found = ir.CreateOr(found, lies_in(other, address));
      return ir.CreateNot(found);
  }
}

llvm::Value* Emitter::symbol_pointer(const std::string& name) {
  const auto offset_from = [&](std::size_t field, std::uint32_t offset) {
    return ir.CreateConstGEP1_64(ir.getInt8Ty(), context_field(field, ir.getPtrTy()), offset);
  };
  if (const auto found = memory_.find(name); found != memory_.end()) return found->second;
  if (const auto found = layout_.parameter_offsets.find(name); found != layout_.parameter_offsets.end())
    return offset_from(offsetof(LaneContext, parameters), found->second);
  if (const auto found = layout_.shared_offsets.find(name); found != layout_.shared_offsets.end())
    return offset_from(offsetof(LaneContext, shared), found->second);
  if (const auto found = layout_.local_offsets.find(name); found != layout_.local_offsets.end())
    return offset_from(offsetof(LaneContext, local), found->second);
  const Variable* variable = module_.find_variable(name);
  return variable ? module_variable(*variable) : nullptr;
}

llvm::GlobalVariable* Emitter::module_variable(const Variable& variable) {
  if (const auto found = globals_.find(variable.name); found != globals_.end()) return found->second;
  if (variable.external || (variable.space != StateSpace::global && variable.space != StateSpace::constant))
    throw_input_error(place(where_, variable.line), fmt::format("variable '{}'", variable.name),
                      "one that this module defines in .global, .const or .shared");
  auto* global = new llvm::GlobalVariable(*entry_->getModule(), storage_type(variable),
                                          variable.space == StateSpace::constant,
                                          llvm::GlobalValue::InternalLinkage, nullptr, variable.name);
  global->setAlignment(llvm::Align(std::max(variable.alignment, 1u)));
  // Known before its value is built: initialisers may take addresses in a circle.
  globals_.emplace(variable.name, global);
  global->setInitializer(initial_value(variable));
  return global;
}

// Bytes; where addresses stand among them, a packed struct of bytes and addresses in turn.
llvm::Type* Emitter::storage_type(const Variable& variable) const {
  const auto bytes = [&](std::uint64_t count) { return llvm::ArrayType::get(ir.getInt8Ty(), count); };
  if (variable.relocations.empty()) return bytes(variable.bytes);
  std::vector<llvm::Type*> parts;
  std::uint64_t done = 0;
  for (const Relocation& relocation : variable.relocations) {
    parts.push_back(bytes(relocation.offset - done));
    parts.push_back(ir.getInt64Ty());
    done = relocation.offset + 8;
  }
  parts.push_back(bytes(variable.bytes - done));
  return llvm::StructType::get(ir.getContext(), parts, /*isPacked=*/true);
}

llvm::Constant* Emitter::initial_value(const Variable& variable) {
  if (variable.initial.empty()) return llvm::Constant::getNullValue(storage_type(variable));
  const auto bytes = [&](std::uint64_t first, std::uint64_t last) {
    return llvm::ConstantDataArray::get(
        ir.getContext(), llvm::ArrayRef(variable.initial.data() + first, variable.initial.data() + last));
  };
  if (variable.relocations.empty()) return bytes(0, variable.bytes);
  std::vector<llvm::Constant*> parts;
  std::uint64_t done = 0;
  for (const Relocation& relocation : variable.relocations) {
    const Variable* target = module_.find_variable(relocation.symbol);
    const auto function = module_.function_address(relocation.symbol);
    if (!target && !function)
      throw_input_error(place(where_, variable.line),
                        fmt::format("the address of '{}' in '{}'", relocation.symbol, variable.name),
                        "a variable or function of this module");
    parts.push_back(bytes(done, relocation.offset));
    llvm::Constant* address = target
                                  ? llvm::ConstantExpr::getPtrToInt(module_variable(*target), ir.getInt64Ty())
                                  : static_cast<llvm::Constant*>(ir.getInt64(*function));
    parts.push_back(llvm::ConstantExpr::getAdd(address, ir.getInt64(relocation.addend)));
    done = relocation.offset + 8;
  }
  parts.push_back(bytes(done, variable.bytes));
  return llvm::ConstantStruct::get(llvm::cast<llvm::StructType>(storage_type(variable)), parts);
}

}  // namespace warpgrain::profiler::ptx
