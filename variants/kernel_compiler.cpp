#include "variants/kernel_compiler.hpp"

#include <array>
#include <fmt/format.h>

#include "core/error.hpp"
#include "variants/nvidia_opencl.hpp"
#include "variants/step_plan.hpp"

#ifdef WARPGRAIN_HAS_SIMULATOR
#include "profiler/build_options.hpp"
#include "profiler/cuda_frontend.hpp"
#include "profiler/opencl_frontend.hpp"
#include "profiler/subprocess.hpp"
#endif

namespace warpgrain {

KernelCompiler kernel_compiler(std::string_view name, std::string_view where) {
  constexpr std::array<std::string_view, 3> names{"clang", "cuda", "nvidia"};
  for (std::size_t k = 0; k < names.size(); ++k)
    if (names[k] == name) return static_cast<KernelCompiler>(k);
  throw_unknown_name(where, "compiler", name, names);
}

#ifdef WARPGRAIN_HAS_SIMULATOR

namespace {

constexpr const char* kernels_name = "kernels";  // in messages

profiler::CompiledPtx compile_as_cuda(const SourceUnit& unit) {
  const profiler::TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "kernels.cu";
  profiler::write_text(file, unit.text);
  profiler::CompiledPtx compiled = profiler::compile_cuda(file, cuda_build_options(unit.build_options));
  // Names of files are those of #line, which the compilers take to lie in the folder that they run in.
  for (const std::filesystem::path& folder_name : {folder.path(), std::filesystem::current_path()}) {
    const std::string before = fmt::format("\"{}/", folder_name.string());
    for (std::size_t at = compiled.ptx.find(before); at != std::string::npos;
         at = compiled.ptx.find(before, at + 1))
      compiled.ptx.erase(at + 1, before.size() - 1);
  }
  return compiled;
}

}  // namespace

std::string cuda_build_options(std::string_view opencl_options) {
  // What OpenCL C asks of divisions and roots unless it is told otherwise.
  std::string accuracy = "--prec-div=false --prec-sqrt=false", options;
  const std::vector<std::string> words = profiler::split_words(opencl_options);
  for (std::size_t k = 0; k < words.size(); ++k) {
    const std::string& word = words[k];
    if (word == "-D" && k + 1 < words.size())
      options += fmt::format(" -D {}", words[++k]);
    else if (word.starts_with("-D"))
      options += ' ' + word;
    else if (word == "-cl-fast-relaxed-math")
      accuracy = "--use_fast_math";
    else if (word == "-cl-fp32-correctly-rounded-divide-sqrt")
      accuracy = "--prec-div=true --prec-sqrt=true";
    else if (word == "-cl-denorms-are-zero")
      options += " --ftz=true";
    else if (!word.starts_with("-cl-std="))
      throw_input_error("--compiler cuda", fmt::format("the build option '{}'", word),
                        "-D or an option for subnormal numbers or for the accuracy of divisions and roots");
  }
  return "--std=c++17 " + accuracy + options;
}

profiler::CompiledPtx compile_unit(const SourceUnit& unit, KernelCompiler compiler) {
  switch (compiler) {
    case KernelCompiler::cuda:
      return compile_as_cuda(unit);
    case KernelCompiler::nvidia: {
      NvidiaPtx made = nvidia_opencl_ptx(unit.text, unit.build_options);
      return {std::move(made.ptx), std::move(made.driver), unit.build_options};
    }
    case KernelCompiler::clang:
      break;
  }
  return profiler::compile_opencl(unit.text, kernels_name, unit.build_options);
}

#endif

}  // namespace warpgrain
