#include "profiler/sass/ptxas.hpp"

#include <cstdlib>
#include <fmt/format.h>
#include <unistd.h>
#include <vector>

#include "core/error.hpp"
#include "profiler/subprocess.hpp"

namespace warpgrain::profiler::sass {
namespace {

std::filesystem::path program_path() {
  if (std::filesystem::path found = find_program("ptxas"); !found.empty()) return found;
  std::vector<std::filesystem::path> toolkits;
  for (const char* variable : {"CUDA_HOME", "CUDA_PATH"})
    if (const char* const folder = std::getenv(variable)) toolkits.emplace_back(folder);
  if (toolkits.empty()) toolkits.emplace_back("/usr/local/cuda");
  for (const std::filesystem::path& toolkit : toolkits)
    if (const auto program = toolkit / "bin" / "ptxas"; access(program.c_str(), X_OK) == 0) return program;
  return {};
}

// "Cuda compilation tools, release 13.0, V13.0.88"
std::string version_in(const std::string& text) {
  const std::size_t at = text.find(", V");
  if (at == std::string::npos) return "unknown";
  const std::size_t begin = at + 3;
  return text.substr(begin, text.find_first_not_of("0123456789.", begin) - begin);
}

}  // namespace

std::optional<Ptxas> find_ptxas() {
  const std::filesystem::path program = program_path();
  if (program.empty()) return std::nullopt;
  return Ptxas{program, version_in(run_process({program, "--version"}).output)};
}

std::string assemble(const Ptxas& ptxas, std::string_view ptx, std::string_view arch, LineTable lines) {
  const TemporaryFolder folder;
  const std::string input = folder.path() / "kernel.ptx", output = folder.path() / "kernel.cubin";
  write_text(input, ptx);
  std::vector<std::string> arguments{ptxas.program, fmt::format("-arch={}", arch)};
  if (lines == LineTable::with) arguments.emplace_back("-lineinfo");
  arguments.insert(arguments.end(), {input, "-o", output});
  const ProcessResult result = run_process(arguments);
  if (result.exit_status != 0)
    throw_input_error(fmt::format("{} for {}", ptxas.program.string(), arch),
                      result.errors.substr(0, result.errors.find('\n')),
                      "PTX and an architecture that it takes");
  return read_text(output);
}

}  // namespace warpgrain::profiler::sass
