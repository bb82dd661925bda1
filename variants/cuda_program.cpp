#include "variants/cuda_program.hpp"

#include <array>
#include <fmt/format.h>
#include <regex>

#include "core/error.hpp"
#include "profiler/subprocess.hpp"

namespace warpgrain {
namespace {

std::filesystem::path find_ptxas() {
  if (std::filesystem::path on_path = profiler::find_program("ptxas"); !on_path.empty()) return on_path;
  const std::filesystem::path usual = "/usr/local/cuda/bin/ptxas";
  if (std::filesystem::exists(usual)) return usual;
  throw_input_error("ptxas", "not on PATH and not in /usr/local/cuda/bin", "an installed CUDA toolkit");
}

// The line with the release of four: "Cuda compilation tools, release 13.0, V13.0.88".
std::string version_of(const std::filesystem::path& ptxas) {
  const std::string text = profiler::run_process({ptxas, "--version"}).output;
  const std::size_t begin = text.find("release");
  return fmt::format("ptxas {}", begin == std::string::npos
                                     ? "of unknown version"
                                     : text.substr(begin, text.find('\n', begin) - begin));
}

}  // namespace

CudaAssembler cuda_assembler(std::string_view name, std::string_view where) {
  constexpr std::array<std::string_view, 2> names{"driver", "ptxas"};
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<CudaAssembler>(k);
  throw_unknown_name(where, "assembler", name, names);
}

std::string ptx_for_cuda(std::string_view ptx, std::string_view where) {
  std::string text(ptx.substr(0, ptx.find('\0')));
  if (text.find(".ptr .const") != std::string::npos) {
    if (std::regex_search(text, std::regex(R"((^|\n)(\.visible )?\.const )")))
      throw_input_error(where, "a kernel with a pointer to constant memory beside constant variables",
                        "one or the other: CUDA passes pointers to global memory alone");
    // Its memory is a buffer here, and all loads of constants are from such buffers.
    text = std::regex_replace(text, std::regex(R"(\.ptr \.const)"), ".ptr .global");
    text = std::regex_replace(text, std::regex(R"(\bld\.const\b)"), "ld.global");
  }
  text = std::regex_replace(text, std::regex(R"((\.target[^\n]*?), *texmode_independent)"), "$1");
  text = std::regex_replace(text, std::regex(R"(\.ptr +\.shared +\.align +\d+ )"), "");
  return std::regex_replace(text, std::regex(R"(%envreg\d+)"), "0");
}

CudaProgram assemble_for_cuda(const CudaDevice& device, CudaAssembler assembler, std::string_view ptx,
                              std::string_view where) {
  CudaProgram program{ptx_for_cuda(ptx, where), {}, {}};
  if (assembler == CudaAssembler::driver) {
    program.assembler = fmt::format("driver {}", device.driver());
    return program;
  }
  const std::filesystem::path ptxas = find_ptxas();
  const profiler::TemporaryFolder folder;
  const std::string input = folder.path() / "kernel.ptx", output = folder.path() / "kernel.cubin";
  profiler::write_text(input, program.ptx);
  const std::string architecture = "-arch=" + device.architecture();
  const profiler::ProcessResult result = profiler::run_process({ptxas, architecture, input, "-o", output});
  if (result.exit_status != 0)
    throw InputError(fmt::format("{}: ptxas {} refuses it\n{}", where, architecture, result.errors));
  program.cubin = profiler::read_text(output);
  program.assembler = fmt::format("{}, {}", version_of(ptxas), architecture);
  return program;
}

CudaModule load_program(const CudaDevice& device, const CudaProgram& program, std::string_view where) {
  return {device, program.cubin.empty() ? program.ptx : program.cubin, where};
}

}  // namespace warpgrain
