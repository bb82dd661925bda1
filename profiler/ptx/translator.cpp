#include "profiler/ptx/translator.hpp"

#include <algorithm>
#include <cstddef>
#include <fmt/format.h>

#include "core/error.hpp"
#include "profiler/ptx/emit_half.hpp"
#include "profiler/ptx/emit_printf.hpp"
#include "profiler/ptx/emitter.hpp"
#include "profiler/ptx/instructions.hpp"

namespace warpgrain::profiler::ptx {
namespace {

class Translator {
 public:
  Translator(const Module& module, const Function& kernel, std::span<const Block> blocks,
             const MemoryLayout& layout, const Instrumentation& instrumentation, const Provenance* provenance,
             std::string_view where, llvm::Module& out)
      : kernel_(kernel),
        blocks_(blocks),
        loop_costs_(instrumentation.loop_costs),
        provenance_(provenance),
        where_(where),
        lane_(make_function(out)),
        ir_(llvm::BasicBlock::Create(out.getContext(), "registers", lane_)),
        trace_(ir_, lane_->getArg(0), instrumentation.mode),
        emitter_(ir_, lane_->getArg(0), module, kernel, layout, provenance, trace_, where) {}

  void run() {
    for (const Block& block : blocks_) starts_.push_back(new_block(block.label));
    ir_.CreateBr(starts_[0]);
    for (std::size_t b = 0; b < blocks_.size(); ++b) emit_block(static_cast<std::uint32_t>(b));
    if (provenance_)
      emitter_.list_variables(llvm::StringRef(variable_list_name.data(), variable_list_name.size()));
  }

  std::vector<AccessSite> take_sites() { return std::move(emitter_.sites); }

 private:
  static llvm::Function* make_function(llvm::Module& out) {
    llvm::LLVMContext& context = out.getContext();
    auto* type = llvm::FunctionType::get(llvm::Type::getVoidTy(context),
                                         {llvm::PointerType::getUnqual(context)}, false);
    auto* function =
        llvm::Function::Create(type, llvm::GlobalValue::ExternalLinkage,
                               llvm::StringRef(lane_function_name.data(), lane_function_name.size()), out);
    function->setDoesNotThrow();
    function->addParamAttr(0, llvm::Attribute::NoAlias);
    return function;
  }

  llvm::BasicBlock* new_block(const std::string& name) {
    return llvm::BasicBlock::Create(ir_.getContext(), name, lane_);
  }

  void emit_block(std::uint32_t index) {
    const Block& block = blocks_[index];
    ir_.SetInsertPoint(starts_[index]);
    emitter_.access_slot = 0;
    emitter_.block = index;
    if (block.loop_header) emit_loop_check(index);
    if (block.recorded) trace_.record_block(index);
    const bool has_terminator = block.first < block.last && is_terminator(kernel_.statements[block.last - 1]);
    for (std::size_t i = block.first; i < block.last - (has_terminator ? 1 : 0); ++i)
      emit_statement(kernel_.statements[i]);
    trace_.advance_addresses(emitter_.access_slot);
    if (has_terminator)
      emit_terminator(block, kernel_.statements[block.last - 1]);
    else if (!block.successors.empty())
      ir_.CreateBr(starts_[block.successors[0]]);
    else
      end_lane();
  }

  // A lane runs without end only in a loop, so that it is enough to look there; the buffers have room for one
  // pass over every block behind their limit.
  void emit_loop_check(std::uint32_t index) {
    const std::uint32_t line = blocks_[index].first < kernel_.statements.size()
                                   ? kernel_.statements[blocks_[index].first].line
                                   : kernel_.line;
    if (never_left(index)) {
      stop_lane(status_value(LaneStatus::endless_loop), line);
      // What follows cannot be reached.
      ir_.SetInsertPoint(new_block("unreachable"));
      return;
    }
    llvm::Value* overspent = ir_.CreateICmpSLT(emitter_.spend(loop_costs_[index]), ir_.getInt64(0));
    llvm::Value* exhausted = overspent;
    if (llvm::Value* full = trace_.is_exhausted()) exhausted = ir_.CreateOr(overspent, full);
    llvm::BasicBlock* stop = new_block("exhausted");
    llvm::BasicBlock* go_on = new_block(blocks_[index].label + ".body");
    ir_.CreateCondBr(exhausted, stop, go_on);
    ir_.SetInsertPoint(stop);
    stop_lane(ir_.CreateSelect(overspent, status_value(LaneStatus::budget_exhausted),
                               status_value(LaneStatus::trace_exhausted)),
              line);
    ir_.SetInsertPoint(go_on);
  }

  // Whether every block of the loop has one way on. Such a loop records nothing, so that no trace would show
  // it.
  bool never_left(std::uint32_t header) const {
    for (std::uint32_t block = header; blocks_[block].successors.size() == 1;) {
      block = blocks_[block].successors[0];
      if (block == header) return true;
    }
    return false;
  }

  void emit_statement(const Statement& statement) {
    emitter_.begin(statement);
    if (!statement.guard) {
      emit_instruction(statement);
      return;
    }
    // In place of a branch of its own, which the PTX does not have and the trace does not show.
    const std::uint32_t first_slot = emitter_.access_slot;
    llvm::BasicBlock* start = ir_.GetInsertBlock();
    llvm::BasicBlock* perform = new_block("predicated");
    llvm::BasicBlock* behind = new_block("behind");
    llvm::Value* condition = read_guard(statement);
    ir_.SetInsertPoint(perform);
    emit_instruction(statement);
    ir_.CreateBr(behind);
    ir_.SetInsertPoint(start);
    for (std::uint32_t slot = first_slot; slot < emitter_.access_slot; ++slot)
      trace_.record_address(slot, ir_.getInt64(no_address));
    ir_.CreateCondBr(condition, perform, behind);
    ir_.SetInsertPoint(behind);
  }

  void emit_instruction(const Statement& statement) {
    if (statement.opcode == "call") {
      // Of other calls the function's blocks follow.
      if (!statement.operands.empty()) emit_printf(emitter_);
      return;
    }
    find_instruction(statement)(emitter_);
    emitter_.refuse_surplus_operands();
    emitter_.end();
  }

  InstructionEmitter find_instruction(const Statement& statement) const {
    if (is_half_arithmetic(statement)) return half_instructions().at(statement.opcode);
    for (const InstructionTable* table :
         {&arithmetic_instructions(), &float_instructions(), &bit_instructions(), &compare_instructions(),
          &move_instructions(), &memory_instructions(), &barrier_instructions(), &warp_instructions(),
          &integer_instructions(), &convert_instructions(), &other_instructions()})
      if (const auto found = table->find(statement.opcode); found != table->end()) return found->second;
    emitter_.refuse(what_is_expected_instead(statement.opcode));
  }

  llvm::Value* read_guard(const Statement& statement) {
    Operand predicate;
    predicate.name = statement.guard->predicate;
    predicate.negated = statement.guard->negated;
    return emitter_.read(predicate, predicate_type);
  }

  void emit_terminator(const Block& block, const Statement& statement) {
    emitter_.begin(statement);
    emitter_.modifiers().take("uni");
    if (statement.opcode == "brx") {
      emit_table_branch(block, statement);
    } else if (statement.opcode == "call") {
      emit_indirect_call(statement);
    } else if (statement.opcode == "bra" || statement.guard) {
      emit_branch(block, statement);
    } else {
      end_lane(statement);
    }
    emitter_.end();
  }

  void emit_branch(const Block& block, const Statement& statement) {
    if (!statement.guard) {
      ir_.CreateBr(starts_[block.successors[0]]);
      return;
    }
    llvm::Value* condition = read_guard(statement);
    llvm::BasicBlock* taken = starts_[block.successors[0]];
    // The empty block that a predicated trap leads to does not know that it is one.
    if (statement.opcode == "trap") {
      taken = new_block("trap");
      llvm::BasicBlock* start = ir_.GetInsertBlock();
      ir_.SetInsertPoint(taken);
      if (blocks_[block.successors[0]].recorded) trace_.record_block(block.successors[0]);
      end_lane(statement);
      ir_.SetInsertPoint(start);
    }
    ir_.CreateCondBr(condition, taken, starts_[block.successors.back()]);
  }

  void emit_table_branch(const Block& block, const Statement& statement) {
    emitter_.modifiers().take("idx");
    if (statement.guard) {
      llvm::BasicBlock* table = new_block("table");
      ir_.CreateCondBr(read_guard(statement), table, starts_[block_at(blocks_, block.last)]);
      ir_.SetInsertPoint(table);
    }
    const std::vector<std::string> targets = branch_targets(kernel_, statement, where_);
    llvm::Value* index = emitter_.read(0, bits_type(32));
    // An index beyond the table is undefined in PTX; it takes the last entry.
    llvm::SwitchInst* table =
        ir_.CreateSwitch(index, start_of(targets.back()), static_cast<unsigned>(targets.size()));
    for (std::uint32_t i = 0; i < targets.size(); ++i) table->addCase(ir_.getInt32(i), start_of(targets[i]));
  }

  void emit_indirect_call(const Statement& statement) {
    llvm::Value* function = emitter_.read(0, bits_type(64));
    llvm::BasicBlock* call = ir_.GetInsertBlock();
    llvm::BasicBlock* none = new_block("no_function");
    ir_.SetInsertPoint(none);
    stop_lane(status_value(LaneStatus::no_function), statement.line);
    ir_.SetInsertPoint(call);
    llvm::SwitchInst* functions = ir_.CreateSwitch(function, none);
    for (std::size_t i = 1; i < statement.operands.size(); ++i)
      functions->addCase(ir_.getInt64(statement.operands[i].value), start_of(statement.operands[i].name));
  }

  llvm::BasicBlock* start_of(const std::string& label) const {
    return starts_[block_at(blocks_, kernel_.labels.at(label))];
  }

  void end_lane(const Statement& statement) {
    if (statement.opcode == "trap")
      stop_lane(status_value(LaneStatus::trapped), statement.line);
    else
      end_lane();
  }

  void end_lane() {
    trace_.finish();
    ir_.CreateRetVoid();
  }

  llvm::Value* status_value(LaneStatus status) { return ir_.getInt32(static_cast<std::uint32_t>(status)); }

  void stop_lane(llvm::Value* status, std::uint32_t line) {
    ir_.CreateStore(status, emitter_.context_pointer(offsetof(LaneContext, status)));
    ir_.CreateStore(ir_.getInt32(line), emitter_.context_pointer(offsetof(LaneContext, line)));
    end_lane();
  }

  const Function& kernel_;
  std::span<const Block> blocks_;
  std::span<const std::uint32_t> loop_costs_;
  const Provenance* provenance_;
  std::string_view where_;
  llvm::Function* lane_;
  llvm::IRBuilder<> ir_;
  TraceEmitter trace_;
  Emitter emitter_;
  std::vector<llvm::BasicBlock*> starts_;
};

bool is_fence(const Statement& s) { return s.opcode == "membar" || s.opcode == "fence"; }

}  // namespace

MemoryFacts translate(const Module& module, const Function& kernel, std::span<const Block> blocks,
                      const MemoryLayout& layout, const Instrumentation& instrumentation,
                      std::string_view where, llvm::Module& out) {
  std::optional<Provenance> provenance;
  if (instrumentation.checks == Checks::on) provenance.emplace(module, kernel, layout);
  Translator translator(module, kernel, blocks, layout, instrumentation, provenance ? &*provenance : nullptr,
                        where, out);
  translator.run();
  MemoryFacts facts;
  if (!provenance) return facts;
  facts.objects = provenance->objects();
  facts.sites = translator.take_sites();
  facts.has_fence = std::any_of(kernel.statements.begin(), kernel.statements.end(), is_fence);
  return facts;
}

}  // namespace warpgrain::profiler::ptx
