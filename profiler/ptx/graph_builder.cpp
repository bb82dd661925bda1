#include "profiler/ptx/graph_builder.hpp"

#include <map>

#include "profiler/ptx/instruction_facts.hpp"

namespace warpgrain::profiler::ptx {

KernelGraph build_graph(const Module& module, const Function& kernel, std::span<const Block> blocks,
                        const MemoryLayout& layout) {
  KernelGraph graph;
  graph.kernel = graph.entry = kernel.name;
  graph.shared_bytes = layout.shared_bytes;
  std::map<std::uint32_t, std::uint32_t> file_index;
  for (const auto& [number, name] : module.files) {
    file_index[number] = static_cast<std::uint32_t>(graph.files.size());
    graph.files.push_back(name);
  }
  const auto located = [&](SourceLocation location) {
    const auto found = file_index.find(location.file);
    if (found != file_index.end()) return SourceLocation{found->second, location.line};
    if (graph.files.empty()) graph.files.emplace_back();
    return SourceLocation{};
  };

  for (const Block& block : blocks) {
    BasicBlock basic_block;
    basic_block.label = block.label;
    basic_block.successors = block.successors;
    basic_block.recorded = block.recorded;
    for (std::size_t i = block.first; i < block.last; ++i) {
      const Statement& statement = kernel.statements[i];
      const InstructionFacts facts = instruction_facts(statement);
      if (facts.accessed_bytes > 0)
        basic_block.accesses.push_back({static_cast<std::uint32_t>(basic_block.instructions.size()),
                                        facts.instruction_class, facts.accessed_bytes});
      if (facts.records_path)
        basic_block.accesses.push_back({static_cast<std::uint32_t>(basic_block.instructions.size()),
                                        facts.instruction_class, 0});  // see is_path
      if (facts.instruction_class == InstructionClass::barrier) graph.has_barrier = true;
      if (facts.instruction_class == InstructionClass::warp_level) graph.has_warp_level = true;
      basic_block.instructions.push_back({facts.instruction_class, facts.sfu_operations,
                                          located(statement.location), statement.text, statement.line});
    }
    graph.blocks.push_back(std::move(basic_block));
  }
  return graph;
}

}  // namespace warpgrain::profiler::ptx
