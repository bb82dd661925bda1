#pragma once
// LLVM IR -> native code for this host.

#include <llvm/ExecutionEngine/Orc/ThreadSafeModule.h>
#include <memory>
#include <string_view>

namespace warpgrain::profiler {

// Owns the code; its addresses are valid while it lives.
class Jit {
 public:
  Jit();
  ~Jit();
  Jit(const Jit&) = delete;
  Jit& operator=(const Jit&) = delete;

  // Sets the module's target and layout. Before the module is filled: alignments follow from it.
  void prepare(llvm::Module& module) const;
  // Turns memory into registers, compiles, and returns the address of `symbol`. The control flow stays as it
  // is: every pass that would change it is left out.
  void* compile(llvm::orc::ThreadSafeModule module, std::string_view symbol);
  // The address of another symbol of what was compiled.
  void* find(std::string_view symbol);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace warpgrain::profiler
