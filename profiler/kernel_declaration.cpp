#include "profiler/kernel_declaration.hpp"

#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/IR/Function.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Metadata.h>
#include <llvm/IR/Module.h>
#include <stdexcept>

namespace warpgrain::profiler {
namespace {

std::string string_at(const llvm::MDNode* strings, unsigned index) {
  if (strings == nullptr || index >= strings->getNumOperands()) return {};
  const auto* text = llvm::dyn_cast<llvm::MDString>(strings->getOperand(index));
  return text == nullptr ? std::string() : text->getString().str();
}

}  // namespace

std::vector<ParameterDeclaration> parameters_in_bitcode(std::string_view bitcode, std::string_view kernel) {
  llvm::LLVMContext context;
  auto module = llvm::parseBitcodeFile(
      llvm::MemoryBufferRef(llvm::StringRef(bitcode.data(), bitcode.size()), "kernel.bc"), context);
  if (!module) throw std::runtime_error("clang's bitcode: " + llvm::toString(module.takeError()));
  std::vector<ParameterDeclaration> parameters;
  const llvm::Function* function = (*module)->getFunction(llvm::StringRef(kernel.data(), kernel.size()));
  if (function == nullptr) return parameters;
  const llvm::MDNode* names = function->getMetadata("kernel_arg_name");
  const llvm::MDNode* types = function->getMetadata("kernel_arg_base_type");
  for (unsigned i = 0; i < function->arg_size(); ++i)
    parameters.push_back({string_at(names, i), string_at(types, i)});
  return parameters;
}

}  // namespace warpgrain::profiler
