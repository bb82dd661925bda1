#include "profiler/constant_padding.hpp"

#include <llvm/Bitcode/BitcodeReader.h>
#include <llvm/Bitcode/BitcodeWriter.h>
#include <llvm/IR/Constants.h>
#include <llvm/IR/GlobalVariable.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>
#include <llvm/Support/raw_ostream.h>
#include <stdexcept>
#include <vector>

namespace warpgrain::profiler {
namespace {

// The type with 4-vectors for 3-vectors: of the same size and alignment, with every part in the same place.
llvm::Type* padded_type(llvm::Type* type) {
  if (auto* vector = llvm::dyn_cast<llvm::FixedVectorType>(type))
    return vector->getNumElements() == 3 ? llvm::FixedVectorType::get(vector->getElementType(), 4) : type;
  if (auto* array = llvm::dyn_cast<llvm::ArrayType>(type))
    return llvm::ArrayType::get(padded_type(array->getElementType()), array->getNumElements());
  if (auto* record = llvm::dyn_cast<llvm::StructType>(type)) {
    std::vector<llvm::Type*> parts;
    for (llvm::Type* part : record->elements()) parts.push_back(padded_type(part));
    // An unnamed struct of other parts; the same one where there is nothing to pad.
    return llvm::ArrayRef(parts) == record->elements()
               ? type
               : llvm::StructType::get(type->getContext(), parts, record->isPacked());
  }
  return type;
}

llvm::Constant* padded_value(llvm::Constant* value) {
  llvm::Type* const type = padded_type(value->getType());
  if (type == value->getType()) return value;
  if (llvm::isa<llvm::UndefValue>(value)) return llvm::UndefValue::get(type);
  if (value->isNullValue()) return llvm::Constant::getNullValue(type);
  std::vector<llvm::Constant*> parts;
  for (unsigned i = 0; llvm::Constant* part = value->getAggregateElement(i); ++i)
    parts.push_back(padded_value(part));
  if (auto* vector = llvm::dyn_cast<llvm::FixedVectorType>(type)) {
    parts.push_back(llvm::Constant::getNullValue(vector->getElementType()));
    return llvm::ConstantVector::get(parts);
  }
  if (auto* array = llvm::dyn_cast<llvm::ArrayType>(type)) return llvm::ConstantArray::get(array, parts);
  return llvm::ConstantStruct::get(llvm::cast<llvm::StructType>(type), parts);
}

}  // namespace

std::optional<std::string> pad_vectors_of_three(std::string_view bitcode) {
  llvm::LLVMContext context;
  auto parsed = llvm::parseBitcodeFile(
      llvm::MemoryBufferRef(llvm::StringRef(bitcode.data(), bitcode.size()), "kernel.bc"), context);
  if (!parsed) throw std::runtime_error("clang's bitcode: " + llvm::toString(parsed.takeError()));
  llvm::Module& module = **parsed;
  std::vector<llvm::GlobalVariable*> to_pad;
  for (llvm::GlobalVariable& variable : module.globals())
    if (variable.hasInitializer() && padded_type(variable.getValueType()) != variable.getValueType())
      to_pad.push_back(&variable);
  if (to_pad.empty()) return std::nullopt;
  for (llvm::GlobalVariable* variable : to_pad) {
    llvm::Constant* const value = padded_value(variable->getInitializer());
    auto* const padded = new llvm::GlobalVariable(
        module, value->getType(), variable->isConstant(), variable->getLinkage(), value, "", variable,
        variable->getThreadLocalMode(), variable->getAddressSpace());
    padded->copyAttributesFrom(variable);
    padded->copyMetadata(variable, 0);
    padded->takeName(variable);
    variable->replaceAllUsesWith(padded);
    variable->eraseFromParent();
  }
  std::string result;
  llvm::raw_string_ostream out(result);
  llvm::WriteBitcodeToFile(module, out);
  return out.str();
}

}  // namespace warpgrain::profiler
