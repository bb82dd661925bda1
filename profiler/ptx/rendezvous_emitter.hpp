#pragma once
// The code by which a lane waits for others.

#include "profiler/ptx/emitter.hpp"
#include "profiler/rendezvous.hpp"

namespace warpgrain::profiler::ptx {

// Fields of a Rendezvous; those that are null stay 0.
struct RendezvousFields {
  llvm::Value* members = nullptr;  // null: of a form that names none
  llvm::Value* index = nullptr;
  llvm::Value* bound = nullptr;
  llvm::Value* value = nullptr;  // of any integer type up to 64 bits
  bool aligned = false;
};

// Fills in the lane's rendezvous and waits.
void emit_rendezvous(Emitter& emitter, Meeting meeting, const RendezvousFields& fields);

// The answer.
llvm::Value* rendezvous_result(Emitter& emitter, llvm::IntegerType* type);
llvm::Value* rendezvous_holds(Emitter& emitter);  // an i1

}  // namespace warpgrain::profiler::ptx
