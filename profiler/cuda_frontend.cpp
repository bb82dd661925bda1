#include "profiler/cuda_frontend.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <vector>

#include "core/error.hpp"
#include "profiler/build_options.hpp"
#include "profiler/nvrtc.hpp"
#include "profiler/subprocess.hpp"

namespace warpgrain::profiler {
namespace {

constexpr const char* toolkit = "/usr/local/cuda";

std::filesystem::path find_nvcc() {
  if (std::filesystem::path on_path = find_program("nvcc"); !on_path.empty()) return on_path;
  const std::filesystem::path usual = std::filesystem::path(toolkit) / "bin/nvcc";
  return std::filesystem::exists(usual) ? usual : std::filesystem::path();
}

bool names_architecture(const std::vector<std::string>& options) {
  return std::ranges::any_of(options, [](const std::string& option) {
    return option.starts_with("-arch") || option.starts_with("--gpu-architecture") ||
           option.starts_with("-gencode") || option.starts_with("--generate-code");
  });
}

std::vector<std::string> options_for(std::string_view architecture,
                                     const std::vector<std::string>& user_options) {
  std::vector<std::string> options{"-lineinfo"};
  if (!names_architecture(user_options)) options.push_back(fmt::format("-arch={}", architecture));
  options.insert(options.end(), user_options.begin(), user_options.end());
  return options;
}

// The compilers make the paths of .file whole; messages and labels speak of the file as the caller does.
void restore_name(std::string& ptx, const std::filesystem::path& path) {
  const std::string whole =
      fmt::format("\"{}\"", std::filesystem::absolute(path).lexically_normal().string());
  const std::string given = fmt::format("\"{}\"", path.string());
  for (std::size_t at = ptx.find(whole); at != std::string::npos; at = ptx.find(whole, at + given.size()))
    ptx.replace(at, whole.size(), given);
}

[[noreturn]] void refuse(const std::filesystem::path& path, std::string_view messages) {
  while (messages.ends_with('\n')) messages.remove_suffix(1);
  throw InputError(fmt::format("{}: it does not compile\n{}", path.string(), messages));
}

// "Cuda compilation tools, release 13.0, V13.0.88"
std::string version_of(const std::filesystem::path& nvcc) {
  const std::string text = run_process({nvcc, "--version"}).output;
  const std::size_t begin = std::min(text.find("Cuda compilation tools"), text.size());
  return "nvcc: " + text.substr(begin, text.find('\n', begin) - begin);
}

CompiledPtx run_nvcc(const std::filesystem::path& nvcc, const std::filesystem::path& path,
                     const std::vector<std::string>& user_options) {
  const TemporaryFolder folder;
  const std::filesystem::path output = folder.path() / "kernel.ptx";
  const std::vector<std::string> options = options_for("sm_80", user_options);
  std::vector<std::string> arguments{nvcc, "-ptx"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), {"-o", output, path});
  const ProcessResult result = run_process(arguments);
  if (result.exit_status != 0) refuse(path, result.errors + result.output);
  return {read_text(output), version_of(nvcc), fmt::format("nvcc -ptx {}", fmt::join(options, " "))};
}

}  // namespace

CompiledPtx compile_cuda(const std::filesystem::path& path, std::string_view build_options) {
  const std::vector<std::string> user_options = split_words(build_options);
  CompiledPtx compiled;
  if (const std::filesystem::path nvcc = find_nvcc(); !nvcc.empty()) {
    compiled = run_nvcc(nvcc, path, user_options);
  } else {
    std::vector<std::string> options = options_for("compute_80", user_options);
    const std::filesystem::path folder = std::filesystem::absolute(path).parent_path();
    options.push_back(fmt::format("-I{}", folder.string()));
    options.push_back(fmt::format("-I{}/include", toolkit));
    const auto result = compile_with_nvrtc(read_text(path), path.string(), options);
    if (!result)
      throw_input_error(path.string(), "there is no compiler of CUDA C++",
                        "nvcc on PATH or in /usr/local/cuda/bin, or libnvrtc.so; or give PTX (.ptx)");
    if (result->ptx.empty()) refuse(path, result->log);
    compiled = {result->ptx, result->version, fmt::format("nvrtc {}", fmt::join(options, " "))};
  }
  restore_name(compiled.ptx, path);
  return compiled;
}

}  // namespace warpgrain::profiler
