#pragma once
// What every instruction's translation works with: the LLVM builder, the registers and memory of the lane,
// and the instruction at hand. Addresses of all state spaces are host addresses.

#include <llvm/IR/IRBuilder.h>
#include <llvm/IR/Module.h>
#include <string>
#include <string_view>
#include <unordered_map>

#include "profiler/ptx/memory_layout.hpp"
#include "profiler/ptx/modifier_reader.hpp"
#include "profiler/ptx/module.hpp"
#include "profiler/ptx/provenance.hpp"
#include "profiler/ptx/trace_emitter.hpp"

namespace warpgrain::profiler::ptx {

class Emitter {
 public:
  // Emits the allocas of the kernel's registers at the builder's place. `provenance`: null for code that does
  // not check its accesses.
  Emitter(llvm::IRBuilder<>& ir, llvm::Value* lane_context, const Module& module, const Function& kernel,
          const MemoryLayout& layout, const Provenance* provenance, TraceEmitter& trace,
          std::string_view where);

  // Makes `statement` the instruction at hand.
  void begin(const Statement& statement);
  // Refuses it when one of its modifiers has not been taken.
  void end();
  // Refuses it when it has operands behind those that were asked for, but for a cache policy.
  void refuse_surplus_operands() const;

  const Statement& statement() const { return *statement_; }
  ModifierReader& modifiers() { return *modifiers_; }
  const Operand& operand(std::size_t index) const;
  std::size_t operand_count() const { return statement_->operands.size(); }
  enum class Types : std::uint8_t { any, number, integer, integer_or_predicate, floating };
  // The next type among the modifiers; the instruction is refused when it is not of these.
  ScalarType take_type(Types types = Types::number);
  // Throws InputError naming the PTX line and the instruction.
  [[noreturn]] void refuse(std::string_view expected = {}) const;

  llvm::IRBuilder<>& ir;

  llvm::Type* type(ScalarType type) const;
  llvm::IntegerType* int_type(unsigned bits) const { return ir.getIntNTy(bits); }

  // The operand's value as `type`: wider registers are cut.
  llvm::Value* read(const Operand& operand, ScalarType type);
  llvm::Value* read(std::size_t index, ScalarType type) { return read(operand(index), type); }
  // Writes a register; one that is wider than `type` is filled by `type`'s sign. `_` takes nothing.
  void write(const Operand& operand, llvm::Value* value, ScalarType type);
  void write(llvm::Value* value, ScalarType type) { write(operand(0), value, type); }
  // The bits of a value of one type as another: bit cast, cut, or extended by `from`'s sign.
  llvm::Value* convert_bits(llvm::Value* value, ScalarType from, ScalarType to);

  // The host address that an address operand or a symbol stands for.
  llvm::Value* pointer(const Operand& operand);
  // Whether a generic address, an i64, lies in a state space: an i1.
  llvm::Value* lies_in(StateSpace space, llvm::Value* address);
  // Where an access through `operand`, whose address is `pointer`, goes: there, or where the check of it
  // leads. `stored`: the elements that a store is going to write.
  llvm::Value* checked(llvm::Value* pointer, const Operand& operand, AccessSite site,
                       llvm::ArrayRef<llvm::Value*> stored = {});
  // The sites of all accesses that are checked, in the order of emission.
  std::vector<AccessSite> sites;
  // Adds the list of the provenance's variables, by which the launch finds their addresses.
  void list_variables(llvm::StringRef name);
  // A field of the lane's context; it does not change while the lane runs.
  llvm::Value* context_field(std::size_t offset, llvm::Type* type);
  llvm::Value* context_pointer(std::size_t offset);
  // Notes the address of an access in the lane's trace.
  void trace_access(llvm::Value* pointer);

  // Memory that lasts as long as the lane runs, at the kernel's entry.
  llvm::AllocaInst* scratch(llvm::Type* type);
  llvm::Value* call_host(std::string_view name, llvm::Type* result, llvm::ArrayRef<llvm::Value*> arguments);
  llvm::Value* call_intrinsic(llvm::Intrinsic::ID id, llvm::Type* type,
                              llvm::ArrayRef<llvm::Value*> arguments) {
    return ir.CreateIntrinsic(id, {type}, arguments);
  }

  // Takes from the lane's budget of instructions; what is left, an i64.
  llvm::Value* spend(std::int64_t instructions);

  // CC.CF, the carry between add.cc, addc and the like: an i1.
  llvm::Value* carry();
  void set_carry(llvm::Value* value);

  // The place of the next traced access in its block; the translator sets it to 0 at a block's start.
  std::uint32_t access_slot = 0;
  // The block that is being translated, by its index in the graph.
  std::uint32_t block = 0;

 private:
  struct Register {
    llvm::AllocaInst* storage;
    ScalarType type;
  };

  llvm::Value* read_name(const Operand& operand, ScalarType type);
  llvm::Value* symbol_pointer(const std::string& name);  // null: no such symbol
  bool fits_symbol(const Operand& operand, const AccessSite& site) const;
  llvm::Value* in_bounds(llvm::Value* address, const AccessSite& site);
  void refuse_beyond_parameter(const Operand& operand, std::uint32_t bytes) const;
  llvm::Value* special_register(const std::string& name);  // an i32 or i64; null: none
  llvm::Value* read_clock();
  llvm::GlobalVariable* module_variable(const Variable& variable);
  llvm::Type* storage_type(const Variable& variable) const;
  llvm::Constant* initial_value(const Variable& variable);

  llvm::Value* lane_context_;
  const Module& module_;
  const Function& kernel_;
  const MemoryLayout& layout_;
  const Provenance* provenance_;
  TraceEmitter& trace_;
  std::string_view where_;
  llvm::BasicBlock* entry_;
  std::unordered_map<std::string, Register> registers_;
  std::unordered_map<std::string, llvm::AllocaInst*> memory_;  // the parameters of calls
  std::unordered_map<std::string, llvm::GlobalVariable*> globals_;
  llvm::AllocaInst* carry_ = nullptr;
  llvm::AllocaInst* budget_ = nullptr;
  const Statement* statement_ = nullptr;
  mutable std::size_t operands_used_ = 0;
  std::optional<ModifierReader> modifiers_;
};

}  // namespace warpgrain::profiler::ptx
