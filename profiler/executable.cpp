#include "profiler/executable.hpp"

#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include "profiler/jit.hpp"
#include "profiler/kernel_name.hpp"
#include "profiler/launch_check.hpp"
#include "profiler/ptx/graph_builder.hpp"
#include "profiler/ptx/inline_calls.hpp"
#include "profiler/ptx/parser.hpp"
#include "profiler/ptx/translator.hpp"
#include "profiler/translated_kernel.hpp"
#include "profiler/work_group.hpp"

namespace warpgrain::profiler {
namespace {

std::vector<std::string_view> entry_names(const ptx::Module& module) {
  std::vector<std::string_view> names;
  for (const ptx::Function& function : module.functions)
    if (function.is_entry && function.has_body) names.emplace_back(function.name);
  return names;
}

class NativeExecutable final : public Executable {
 public:
  NativeExecutable(const ptx::Module& module, const ptx::Function& entry, TraceMode mode,
                   std::string_view where) {
    const ptx::Function kernel = ptx::inline_calls(module, entry, where);
    const std::vector<ptx::Block> blocks = ptx::cut_blocks(kernel, where);
    const ptx::MemoryLayout layout = ptx::lay_out(module, kernel, where);
    kernel_.where = where;
    kernel_.mode = mode;
    kernel_.graph = ptx::build_graph(module, kernel, blocks, layout);
    kernel_.graph.kernel = readable_kernel_name(kernel.name);
    kernel_.is_opencl = module.is_opencl;
    note_signature(kernel, layout);
    note_lines(kernel, blocks);

    auto context = std::make_unique<llvm::LLVMContext>();
    auto translated = std::make_unique<llvm::Module>(kernel.name, *context);
    jit_.prepare(*translated);
    ptx::translate(module, kernel, blocks, layout, mode, where, *translated);
    kernel_.lane = reinterpret_cast<LaneFunction>(
        jit_.compile({std::move(translated), std::move(context)}, ptx::lane_function_name));
  }

  const KernelGraph& graph() const override { return kernel_.graph; }
  std::span<const KernelParameter> parameters() const override { return kernel_.parameters; }

  std::unique_ptr<WorkGroupRunner> runner(const LaunchShape& shape,
                                          std::span<const KernelArgument> arguments) const override {
    check_shape(kernel_, shape);
    check_arguments(kernel_, arguments);
    return std::make_unique<GroupRunner>(kernel_, shape, arguments);
  }

 private:
  void note_signature(const ptx::Function& kernel, const ptx::MemoryLayout& layout) {
    for (const ptx::Variable& p : kernel.parameters) {
      kernel_.parameters.push_back({p.name, static_cast<std::uint32_t>(p.bytes), p.alignment, p.pointer});
      kernel_.parameter_offsets.push_back(layout.parameter_offsets.at(p.name));
    }
    if (layout.dynamic_shared != nullptr) {
      kernel_.parameters.push_back({layout.dynamic_shared->name, 0, layout.dynamic_shared->alignment,
                                    KernelParameter::Pointer::shared});
      kernel_.parameter_offsets.push_back(layout.parameter_bytes);
    }
    kernel_.parameter_bytes = layout.parameter_bytes;
    kernel_.required_local_size = kernel.required_local_size;
    for (const ptx::Variable& v : kernel.variables)
      if (v.space != ptx::StateSpace::shared)
        kernel_.local_bytes += static_cast<std::uint32_t>(v.bytes + v.alignment);
  }

  void note_lines(const ptx::Function& kernel, const std::vector<ptx::Block>& blocks) {
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (std::size_t i = blocks[b].first; i < blocks[b].last; ++i)
        kernel_.statement_lines.emplace_back(
            kernel.statements[i].line, kernel_.graph.blocks[b].instructions[i - blocks[b].first].location);
  }

  TranslatedKernel kernel_;
  Jit jit_;
};

}  // namespace

std::unique_ptr<Executable> Executable::compile(std::string_view ptx, std::string_view kernel, TraceMode mode,
                                                std::string_view where) {
  const ptx::Module module = ptx::parse(ptx, where);
  const ptx::Function* entry = module.find_entry(find_kernel(entry_names(module), kernel, where));
  return std::make_unique<NativeExecutable>(module, *entry, mode, where);
}

std::vector<std::string> kernels_in(std::string_view ptx) {
  const ptx::Module module = ptx::parse(ptx, "PTX");
  const std::vector<std::string_view> names = entry_names(module);
  return {names.begin(), names.end()};
}

}  // namespace warpgrain::profiler
