#pragma once
// The instrumentation: code that appends a lane's blocks and addresses to its trace.

#include <cstdint>
#include <llvm/IR/IRBuilder.h>

#include "profiler/executable.hpp"
#include "profiler/lane_context.hpp"

namespace warpgrain::profiler::ptx {

class TraceEmitter {
 public:
  // Emits the loads of the cursors at the builder's place, which is the function's entry.
  TraceEmitter(llvm::IRBuilder<>& ir, llvm::Value* lane_context, TraceMode mode);

  void record_block(std::uint32_t block);
  // The address of the block's `slot`-th access.
  void record_address(std::uint32_t slot, llvm::Value* address);
  // Behind the last access of a block that has `count` of them.
  void advance_addresses(std::uint32_t count);
  // Whether the trace has come to its limit; null when there is no trace.
  llvm::Value* is_exhausted();
  // Ends the trace and hands the cursors back.
  void finish();

  bool records_addresses() const { return mode_ == TraceMode::blocks_and_addresses; }

 private:
  llvm::Value* field(std::size_t offset);
  llvm::Value* append(llvm::AllocaInst* cursor, llvm::Type* type, std::uint32_t count);

  llvm::IRBuilder<>& ir_;
  llvm::Value* lane_context_;
  TraceMode mode_;
  // The cursors live in allocas, which become registers with those of the PTX.
  llvm::AllocaInst* trace_ = nullptr;
  llvm::AllocaInst* addresses_ = nullptr;
  llvm::Value* trace_limit_ = nullptr;
  llvm::Value* addresses_limit_ = nullptr;
};

}  // namespace warpgrain::profiler::ptx
