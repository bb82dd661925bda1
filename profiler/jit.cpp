#include "profiler/jit.hpp"

#include <llvm/ExecutionEngine/Orc/LLJIT.h>
#include <llvm/IR/Verifier.h>
#include <llvm/Passes/PassBuilder.h>
#include <llvm/Support/TargetSelect.h>
#include <llvm/Support/raw_ostream.h>
#include <llvm/Transforms/InstCombine/InstCombine.h>
#include <llvm/Transforms/Scalar/EarlyCSE.h>
#include <llvm/Transforms/Scalar/SROA.h>
#include <mutex>
#include <stdexcept>
#include <string>

#include "profiler/host_functions.hpp"

namespace warpgrain::profiler {
namespace {

// A failure here is one of this program or its installation, not of an input.
[[noreturn]] void fail(const std::string& what) {
  throw std::runtime_error("just-in-time compiler: " + what);
}

template <class T>
T value_or_fail(llvm::Expected<T> expected) {
  if (!expected) fail(llvm::toString(expected.takeError()));
  return std::move(*expected);
}

void check(llvm::Error error) {
  if (error) fail(llvm::toString(std::move(error)));
}

// Registers in place of memory, then local clean-up.
void optimise(llvm::Module& module) {
  llvm::LoopAnalysisManager loops;
  llvm::FunctionAnalysisManager functions;
  llvm::CGSCCAnalysisManager components;
  llvm::ModuleAnalysisManager modules;
  llvm::PassBuilder builder;
  builder.registerModuleAnalyses(modules);
  builder.registerCGSCCAnalyses(components);
  builder.registerFunctionAnalyses(functions);
  builder.registerLoopAnalyses(loops);
  builder.crossRegisterProxies(loops, functions, components, modules);
  llvm::FunctionPassManager passes;
  passes.addPass(llvm::SROAPass());
  passes.addPass(llvm::EarlyCSEPass());
  passes.addPass(llvm::InstCombinePass());
  llvm::ModulePassManager all;
  all.addPass(llvm::createModuleToFunctionPassAdaptor(std::move(passes)));
  all.run(module, modules);
}

}  // namespace

struct Jit::State {
  std::unique_ptr<llvm::orc::LLJIT> jit;
};

Jit::Jit() : state_(std::make_unique<State>()) {
  static std::once_flag once;
  std::call_once(once, [] {
    llvm::InitializeNativeTarget();
    llvm::InitializeNativeTargetAsmPrinter();
  });
  auto target = value_or_fail(llvm::orc::JITTargetMachineBuilder::detectHost());
  target.setCodeGenOptLevel(llvm::CodeGenOpt::Default);
  // Only what the PTX fuses is fused.
  target.getOptions().AllowFPOpFusion = llvm::FPOpFusion::Strict;
  state_->jit =
      value_or_fail(llvm::orc::LLJITBuilder().setJITTargetMachineBuilder(std::move(target)).create());

  llvm::orc::LLJIT& jit = *state_->jit;
  llvm::orc::SymbolMap symbols;
  for (const HostFunction& function : host_functions())
    symbols[jit.mangleAndIntern(function.name)] = llvm::JITEvaluatedSymbol::fromPointer(function.address);
  check(jit.getMainJITDylib().define(llvm::orc::absoluteSymbols(std::move(symbols))));
  // memset and the like, and fma where the host has no instruction for it.
  jit.getMainJITDylib().addGenerator(value_or_fail(
      llvm::orc::DynamicLibrarySearchGenerator::GetForCurrentProcess(jit.getDataLayout().getGlobalPrefix())));
}

Jit::~Jit() = default;

void Jit::prepare(llvm::Module& module) const {
  module.setDataLayout(state_->jit->getDataLayout());
  module.setTargetTriple(state_->jit->getTargetTriple().str());
}

void* Jit::compile(llvm::orc::ThreadSafeModule module, std::string_view symbol) {
  module.withModuleDo([](llvm::Module& m) {
    std::string message;
    llvm::raw_string_ostream stream(message);
    if (llvm::verifyModule(m, &stream)) fail(message);
    optimise(m);
  });
  check(state_->jit->addIRModule(std::move(module)));
  return find(symbol);
}

void* Jit::find(std::string_view symbol) {
  return value_or_fail(state_->jit->lookup(llvm::StringRef(symbol.data(), symbol.size()))).toPtr<void*>();
}

}  // namespace warpgrain::profiler
