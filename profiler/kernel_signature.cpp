#include "profiler/kernel_signature.hpp"

#include "profiler/kernel_name.hpp"
#include "profiler/ptx/inline_calls.hpp"
#include "profiler/ptx/memory_layout.hpp"
#include "profiler/ptx/parser.hpp"

namespace warpgrain::profiler {

KernelSignature kernel_signature(std::string_view ptx, std::string_view kernel, std::string_view where) {
  const ptx::Module module = ptx::parse(ptx, where);
  std::vector<std::string_view> symbols;
  for (const ptx::Function& function : module.functions)
    if (function.is_entry && function.has_body) symbols.emplace_back(function.name);
  KernelSignature signature{std::string(find_kernel(symbols, kernel, where)), {}};
  const ptx::Function entry = ptx::inline_calls(module, *module.find_entry(signature.symbol), where);
  for (const ptx::Variable& p : entry.parameters)
    signature.parameters.push_back({p.name, static_cast<std::uint32_t>(p.bytes), p.alignment, p.pointer});
  if (const ptx::Variable* shared = ptx::lay_out(module, entry, where).dynamic_shared)
    signature.parameters.push_back({shared->name, 0, shared->alignment, KernelParameter::Pointer::shared});
  return signature;
}

}  // namespace warpgrain::profiler
