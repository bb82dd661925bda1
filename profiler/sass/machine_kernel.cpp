#include "profiler/sass/machine_kernel.hpp"

#include <charconv>
#include <deque>
#include <fmt/format.h>
#include <mutex>
#include <utility>

#include "core/error.hpp"
#include "profiler/sass/cubin.hpp"
#include "profiler/sass/line_directives.hpp"

namespace warpgrain::profiler::sass {
namespace {

struct Cubins {
  std::string plain, with_lines;
};

// A step launches several kernels of one module, some often.
class CubinCache {
 public:
  std::shared_ptr<const Cubins> get(const Ptxas& ptxas, std::string_view ptx, std::string_view arch) {
    const std::lock_guard lock(mutex_);
    for (const Entry& entry : entries_)
      if (entry.ptx == ptx && entry.arch == arch && entry.program == ptxas.program) return entry.cubins;
    auto cubins = std::make_shared<Cubins>();
    const AssemblerText text = assembler_text(ptx);
    cubins->plain = assemble(ptxas, text.plain, arch, LineTable::without);
    cubins->with_lines = assemble(ptxas, text.with_lines, arch, LineTable::with);
    constexpr std::size_t most = 16;
    if (entries_.size() == most) entries_.pop_front();
    entries_.push_back({std::string(ptx), std::string(arch), ptxas.program, cubins});
    return cubins;
  }

 private:
  struct Entry {
    std::string ptx, arch;
    std::filesystem::path program;
    std::shared_ptr<const Cubins> cubins;
  };
  std::mutex mutex_;
  std::deque<Entry> entries_;
};

}  // namespace

MachineKernel::MachineKernel(CodeGraph machine_code, const KernelGraph& graph, std::uint32_t n_registers)
    : registers(n_registers),
      code(std::move(machine_code)),
      decisions(graph),
      plan(make_plan(code, decisions)) {}

unsigned architecture_number(std::string_view arch) {
  constexpr std::string_view prefix = "sm_";
  constexpr unsigned first = 75, last = 90;
  unsigned number = 0;
  const char* const end = arch.data() + arch.size();
  if (arch.starts_with(prefix)) {
    const auto [at, error] = std::from_chars(arch.data() + prefix.size(), end, number);
    const std::string_view suffix(at, static_cast<std::size_t>(end - at));
    if (error == std::errc{} && (suffix.empty() || suffix == "a") && number >= first && number <= last)
      return number;
  }
  throw_input_error("--arch", fmt::format("'{}'", arch), fmt::format("sm_{} to sm_{}", first, last));
}

void require_same_code(const KernelCode& with_lines, const KernelCode& plain, const std::string& kernel) {
  if (with_lines.text != plain.text)
    throw_input_error(kernel, "other machine code with lines than without", "the same");
  if (with_lines.lines.empty()) throw_input_error(kernel, "machine code without lines", "a line table");
}

std::unique_ptr<MachineKernel> assemble_kernel(const Ptxas& ptxas, std::string_view ptx,
                                               const KernelGraph& graph, std::string_view arch) {
  static CubinCache cache;
  const unsigned number = architecture_number(arch);
  const std::shared_ptr<const Cubins> cubins = cache.get(ptxas, ptx, arch);
  const KernelCode code = read_kernel_code(cubins->with_lines, graph.entry);
  require_same_code(code, read_kernel_code(cubins->plain, graph.entry), graph.kernel);
  return std::make_unique<MachineKernel>(cut_code(code, number), graph, code.registers);
}

}  // namespace warpgrain::profiler::sass
