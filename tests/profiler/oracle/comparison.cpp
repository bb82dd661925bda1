#include "tests/profiler/oracle/comparison.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <memory>

#include "profiler/executable.hpp"
#include "profiler/merge.hpp"
#include "profiler/observers/totals.hpp"
#include "profiler/observers/warp_counters.hpp"
#include "profiler/ptx/parser.hpp"
#include "tests/profiler/oracle/lockstep.hpp"

namespace warpgrain::oracle {
namespace {

using profiler::BasicBlock;
using profiler::KernelArgument;
using profiler::KernelGraph;
using profiler::LaunchShape;
using profiler::WarpCounters;

constexpr std::size_t max_lines = 20;

// The contents of the buffers among the arguments.
class Buffers {
 public:
  explicit Buffers(std::span<const KernelArgument> arguments) : arguments_(arguments) {
    for (const KernelArgument& argument : arguments)
      bytes_.emplace_back(argument.memory.begin(), argument.memory.end());
  }
  void restore() const {
    for (std::size_t i = 0; i < bytes_.size(); ++i)
      std::copy(bytes_[i].begin(), bytes_[i].end(), arguments_[i].memory.begin());
  }
  const std::vector<std::byte>& operator[](std::size_t i) const { return bytes_[i]; }

 private:
  std::span<const KernelArgument> arguments_;
  std::vector<std::vector<std::byte>> bytes_;
};

// Runs the launch once and merges its lanes under each setting.
std::vector<WarpCounters> simulate(const profiler::Executable& executable, const LaunchShape& shape,
                                   std::span<const KernelArgument> arguments,
                                   std::span<const Setting> settings) {
  const KernelGraph& graph = executable.graph();
  std::vector<WarpCounters> counters;
  for (const Setting& setting : settings) counters.emplace_back(graph, setting.warp_width);
  std::vector<std::unique_ptr<profiler::WarpMerger>> mergers;
  for (std::size_t i = 0; i < settings.size(); ++i)
    mergers.push_back(profiler::make_counting_merger(graph, settings[i].policy, counters[i]));
  const auto runner = executable.runner(shape, arguments);
  const auto groups = shape.group_count();
  for (std::uint64_t z = 0; z < groups[2]; ++z)
    for (std::uint64_t y = 0; y < groups[1]; ++y)
      for (std::uint64_t x = 0; x < groups[0]; ++x) {
        const auto lanes = runner->run({x, y, z});
        for (std::size_t i = 0; i < settings.size(); ++i)
          for (std::size_t first = 0; first < lanes.size(); first += settings[i].warp_width)
            mergers[i]->merge(
                lanes.subspan(first, std::min<std::size_t>(settings[i].warp_width, lanes.size() - first)));
      }
  return counters;
}

// "3x16 1x32": three executions with 16 active lanes and one with 32.
std::string histogram(std::span<const std::uint64_t> by_lanes) {
  std::string text;
  for (std::size_t lanes = 0; lanes < by_lanes.size(); ++lanes)
    if (by_lanes[lanes] != 0) text += fmt::format("{}{}x{}", text.empty() ? "" : " ", by_lanes[lanes], lanes);
  return text.empty() ? "none" : text;
}

class Differences {
 public:
  Differences(const Program& program, const KernelGraph& graph) : program_(program), graph_(graph) {}

  void compare(const Setting& setting, const WarpCounters& counters, const Counts& counts) {
    setting_ = fmt::format("{}, width {}", profiler::merge_policy_name(setting.policy), setting.warp_width);
    Place place = 0;
    for (std::uint32_t b = 0; b < graph_.blocks.size(); ++b) {
      const BasicBlock& block = graph_.blocks[b];
      for (std::uint32_t i = 0; i < block.instructions.size(); ++i, ++place) {
        if (place == program_.steps.size()) return add(place, "the row ends", block.instructions[i].text);
        if (block.instructions[i].text != program_.steps[place].statement->text)
          return add(place, program_.steps[place].statement->text, block.instructions[i].text);
        compare_step(place, b, i, counters, counts);
      }
    }
    if (place != program_.steps.size()) add(place, program_.steps[place].statement->text, "the kernel ends");
  }

  void compare_buffers(const Setting& setting, std::span<const KernelArgument> arguments,
                       const Buffers& simulated) {
    for (std::size_t i = 0; i < arguments.size(); ++i) {
      const auto& memory = arguments[i].memory;
      const auto [here, there] = std::mismatch(memory.begin(), memory.end(), simulated[i].begin());
      if (here != memory.end() && lines_.size() < max_lines)
        lines_.push_back(fmt::format("{}, width {}: argument {}, byte {}: {:#x}, simulated {:#x}",
                                     profiler::merge_policy_name(setting.policy), setting.warp_width, i,
                                     here - memory.begin(), static_cast<int>(*here),
                                     static_cast<int>(*there)));
    }
  }

  std::vector<std::string> take() { return std::move(lines_); }

 private:
  void compare_step(Place place, std::uint32_t b, std::uint32_t i, const WarpCounters& counters,
                    const Counts& counts) {
    const auto simulated = counters.executions(b);
    if (!std::equal(simulated.begin(), simulated.end(), counts.executions[place].begin()))
      add(place, "executions " + histogram(counts.executions[place]), histogram(simulated));
    const BasicBlock& block = graph_.blocks[b];
    if (i + 1 == block.instructions.size()) {
      expect(place, "divergent", counts.divergent[place], counters.divergent[b]);
      expect(place, "taken lanes", counts.taken_lanes[place], counters.taken_lanes[b]);
    }
    compare_accesses(place, b, i, counters, counts);
  }

  void compare_accesses(Place place, std::uint32_t b, std::uint32_t i, const WarpCounters& counters,
                        const Counts& counts) {
    profiler::MemoryCounters simulated;
    const BasicBlock& block = graph_.blocks[b];
    for (std::size_t k = 0; k < block.accesses.size(); ++k)
      if (block.accesses[k].instruction == i) simulated.add(counters.accesses[counters.first_access[b] + k]);
    const auto found = counts.accesses.find(place);
    const AccessCount counted = found == counts.accesses.end() ? AccessCount{} : found->second;
    expect(place, "requests", counted.requests, simulated.requests);
    expect(place, "useful bytes", counted.useful_bytes, simulated.useful_bytes);
    if (counted.sectors_known) expect(place, "sectors", counted.sectors, simulated.sectors);
  }

  void expect(Place place, std::string_view what, std::uint64_t counted, std::uint64_t simulated) {
    if (counted != simulated) add(place, fmt::format("{} {}", what, counted), fmt::format("{}", simulated));
  }

  void add(Place place, const std::string& interpreted, const std::string& simulated) {
    if (lines_.size() >= max_lines) return;
    const std::string text =
        place < program_.steps.size() ? program_.steps[place].statement->text : "the end";
    lines_.push_back(
        fmt::format("{}: step {}, '{}': {}, simulated {}", setting_, place, text, interpreted, simulated));
  }

  const Program& program_;
  const KernelGraph& graph_;
  std::string setting_;
  std::vector<std::string> lines_;
};

}  // namespace

std::span<const Setting> all_settings() {
  using profiler::MergePolicy;
  static const std::vector<Setting> settings = [] {
    std::vector<Setting> all;
    for (const MergePolicy policy : {MergePolicy::loop_postdom, MergePolicy::ipdom, MergePolicy::min_pc})
      for (const std::uint32_t width : {32U, 8U}) all.push_back({policy, width});
    return all;
  }();
  return settings;
}

std::vector<std::string> differences(std::string_view ptx, std::string_view kernel, const LaunchShape& shape,
                                     std::span<const KernelArgument> arguments,
                                     std::span<const Setting> settings) {
  const Buffers before(arguments);
  const auto executable =
      profiler::Executable::compile(ptx, kernel, profiler::TraceMode::blocks_and_addresses, "compared");
  const std::vector<WarpCounters> simulated = simulate(*executable, shape, arguments, settings);
  const Buffers after(arguments);

  const ptx::Module module = ptx::parse(ptx, "compared");
  const Program program = decode(module, *module.find_entry(kernel));
  const Flow flow(program);
  Differences found(program, executable->graph());
  for (std::size_t i = 0; i < settings.size(); ++i) {
    before.restore();
    const Policy policy(flow, profiler::merge_policy_name(settings[i].policy));
    const Counts counts = run_lockstep(program, flow, policy, settings[i].warp_width, shape, arguments);
    found.compare(settings[i], simulated[i], counts);
    found.compare_buffers(settings[i], arguments, after);
  }
  after.restore();
  return found.take();
}

}  // namespace warpgrain::oracle
