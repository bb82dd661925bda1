#include "profiler/executable.hpp"

#include <fmt/format.h>
#include <llvm/IR/LLVMContext.h>
#include <llvm/IR/Module.h>

#include "core/error.hpp"
#include "profiler/control_flow.hpp"
#include "profiler/division_path.hpp"
#include "profiler/jit.hpp"
#include "profiler/kernel_name.hpp"
#include "profiler/launch_check.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/ptx/graph_builder.hpp"
#include "profiler/ptx/inline_calls.hpp"
#include "profiler/ptx/parser.hpp"
#include "profiler/ptx/translator.hpp"
#include "profiler/safety/launch_monitor.hpp"
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

// Worker threads have stacks of a few MiB.
constexpr std::uint64_t max_frame_bytes = std::uint64_t{4} << 20;

// Refuses what its monitor finds.
class RefusingRunner final : public WorkGroupRunner {
 public:
  RefusingRunner(const Executable& executable, std::unique_ptr<LaunchMonitor> monitor)
      : monitor_(std::move(monitor)), runner_(executable.runner(*monitor_)) {}

  std::span<const LaneTrace> run(const std::array<std::uint64_t, 3>& group) override {
    const std::span<const LaneTrace> traces = runner_->run(group);
    const std::vector<Diagnostic> found = monitor_->diagnostics();
    if (!found.empty())
      throw InputError(fmt::format("{}: {}", monitor_->kernel().place(), diagnostic_text(found.front())));
    return traces;
  }
  std::string take_printed() override { return runner_->take_printed(); }

 private:
  std::unique_ptr<LaunchMonitor> monitor_;
  std::unique_ptr<WorkGroupRunner> runner_;
};

class NativeExecutable final : public Executable {
 public:
  NativeExecutable(std::string_view ptx, const ptx::Module& module, const ptx::Function& entry,
                   TraceMode mode, Checks checks, std::string_view where, bool takes_smaller_groups)
      : ptx_(ptx) {
    const ptx::Function kernel = ptx::inline_calls(module, entry, where);
    const std::vector<ptx::Block> blocks = ptx::cut_blocks(kernel, where);
    const ptx::MemoryLayout layout = ptx::lay_out(module, kernel, where);
    kernel_.where = where;
    kernel_.mode = mode;
    kernel_.checks = checks;
    kernel_.graph = ptx::build_graph(module, kernel, blocks, layout);
    kernel_.graph.kernel = readable_kernel_name(kernel.name);
    kernel_.is_opencl = module.is_opencl;
    kernel_.takes_smaller_groups = takes_smaller_groups;
    note_signature(kernel, layout);
    note_lines(kernel, blocks);
    ptx::Instrumentation instrumentation{mode, checks, note_loops(kernel, blocks)};

    auto context = std::make_unique<llvm::LLVMContext>();
    auto translated = std::make_unique<llvm::Module>(kernel.name, *context);
    jit_.prepare(*translated);
    kernel_.memory = ptx::translate(module, kernel, blocks, layout, instrumentation, where, *translated);
    kernel_.lane = reinterpret_cast<LaneFunction>(
        jit_.compile({std::move(translated), std::move(context)}, ptx::lane_function_name));
    if (checks == Checks::on) note_variables();
  }

  const KernelGraph& graph() const override { return kernel_.graph; }
  std::string_view ptx() const override { return ptx_; }
  std::span<const KernelParameter> parameters() const override { return kernel_.parameters; }

  std::unique_ptr<LaunchMonitor> monitor(const LaunchShape& shape, std::span<const KernelArgument> arguments,
                                         const RunLimits& limits) const override {
    check_shape(kernel_, shape);
    check_arguments(kernel_, arguments);
    return std::make_unique<LaunchMonitor>(kernel_, shape, arguments, limits);
  }
  std::unique_ptr<WorkGroupRunner> runner(LaunchMonitor& monitor) const override {
    return std::make_unique<GroupRunner>(monitor);
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
    kernel_.local_bytes = layout.local_bytes;
    // Every register in a place of its own, and the parameters of calls.
    std::uint64_t frame = kernel.registers.size() * sizeof(std::uint64_t);
    for (const ptx::Variable& v : kernel.variables)
      if (v.space == ptx::StateSpace::parameter) frame += v.bytes + v.alignment;
    if (frame > max_frame_bytes)
      throw_input_error(kernel_.place(), fmt::format("{} bytes of registers", frame),
                        fmt::format("at most {}", max_frame_bytes));
    kernel_.frame_bytes = static_cast<std::uint32_t>(frame);
  }

  // What a pass through each loop costs of a lane's budget, [blocks].
  std::vector<std::uint32_t> note_loops(const ptx::Function& kernel, const std::vector<ptx::Block>& blocks) {
    const KernelGraph& graph = kernel_.graph;
    std::vector<std::uint32_t> costs;
    for (const BasicBlock& block : graph.blocks)
      costs.push_back(static_cast<std::uint32_t>(block.instructions.size()) + 1);
    const ControlFlow flow(graph);
    for (const Loop& loop : flow.loops()) {
      bool reads = false, stores = false;
      std::uint32_t cost = 1;
      for (const std::uint32_t block : loop.blocks) {
        cost += static_cast<std::uint32_t>(graph.blocks[block].instructions.size());
        for (const MemoryAccess& access : graph.blocks[block].accesses) {
          if (is_path(access)) continue;
          stores |= access.access == InstructionClass::global_store ||
                    access.access == InstructionClass::shared_store ||
                    access.access == InstructionClass::generic_store;
          reads = true;
        }
      }
      costs[loop.header] = cost;
      if (blocks[loop.header].first < kernel.statements.size())
        kernel_.loops.push_back({kernel.statements[blocks[loop.header].first].line, reads && !stores});
    }
    return costs;
  }

  void note_variables() {
    auto** const listed = static_cast<std::byte**>(jit_.find(ptx::variable_list_name));
    for (const MemoryObject& object : kernel_.memory.objects)
      if (object.kind == MemoryObject::Kind::variable) kernel_.variables.push_back(listed[object.offset]);
  }

  void note_lines(const ptx::Function& kernel, const std::vector<ptx::Block>& blocks) {
    for (std::size_t b = 0; b < blocks.size(); ++b)
      for (std::size_t i = blocks[b].first; i < blocks[b].last; ++i)
        kernel_.statement_lines.emplace_back(
            kernel.statements[i].line, kernel_.graph.blocks[b].instructions[i - blocks[b].first].location);
  }

  std::string ptx_;
  TranslatedKernel kernel_;
  Jit jit_;
};

}  // namespace

std::unique_ptr<Executable> Executable::compile(std::string_view ptx, std::string_view kernel, TraceMode mode,
                                                std::string_view where, Checks checks) {
  const ptx::Module module = ptx::parse(ptx, where);
  const ptx::Function* entry = module.find_entry(find_kernel(entry_names(module), kernel, where));
  return std::make_unique<NativeExecutable>(ptx, module, *entry, mode, checks, where,
                                            ptx.find(smaller_groups_mark) != std::string_view::npos);
}

std::unique_ptr<WorkGroupRunner> Executable::runner(const LaunchShape& shape,
                                                    std::span<const KernelArgument> arguments) const {
  return std::make_unique<RefusingRunner>(*this, monitor(shape, arguments, {.max_stopped = 1}));
}

std::vector<std::string> kernels_in(std::string_view ptx) {
  const ptx::Module module = ptx::parse(ptx, "PTX");
  const std::vector<std::string_view> names = entry_names(module);
  return {names.begin(), names.end()};
}

}  // namespace warpgrain::profiler
