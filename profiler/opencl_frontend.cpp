#include "profiler/opencl_frontend.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <optional>
#include <sstream>
#include <vector>

#include "core/error.hpp"
#include "profiler/build_options.hpp"
#include "profiler/constant_padding.hpp"
#include "profiler/embedded_builtins.hpp"
#include "profiler/embedded_prelude.hpp"
#include "profiler/kernel_declaration.hpp"
#include "profiler/subprocess.hpp"

namespace warpgrain::profiler {
namespace {

struct Compiler {
  std::string program;
  std::string version;  // first line of --version
};

// LLVM 15 is the one that the profiler itself and Debian 12's PoCL are built on.
std::optional<Compiler> find_compiler() {
  for (const char* name : {"clang-15", "clang"}) {
    const std::filesystem::path program = find_program(name);
    if (program.empty()) continue;
    const std::string text = run_process({program, "--version"}).output;
    std::string first_line = text.substr(0, text.find('\n'));
    if (first_line.find("version 15.") != std::string::npos) return Compiler{program, std::move(first_line)};
  }
  return std::nullopt;
}

const Compiler& compiler() {
  static const std::optional<Compiler> found = find_compiler();
  if (!found)
    throw_input_error("OpenCL C compiler", "no clang of version 15 in PATH",
                      "clang-15 (Debian: apt-get install clang-15)");
  return *found;
}

const std::string& builtin_library() {
  static const std::string found = [] {
    for (const char* path : {"/usr/lib/clc/nvptx64--nvidiacl.bc", "/usr/share/clc/nvptx64--nvidiacl.bc",
                             "/usr/lib/llvm-15/share/clc/nvptx64--nvidiacl.bc"})
      if (std::filesystem::exists(path)) return std::string(path);
    return std::string();
  }();
  if (found.empty())
    throw_input_error("OpenCL C library", "no nvptx64--nvidiacl.bc in /usr/lib/clc or /usr/share/clc",
                      "libclc (Debian: apt-get install libclc-15)");
  return found;
}

// Beyond those that clang's target has by itself.
constexpr const char* extensions =
    "-cl-ext=+cl_khr_fp16,+cl_khr_int64_base_atomics,+cl_khr_int64_extended_atomics";

constexpr const char* builtins_name = "builtins.bc";

// The pinned pipeline. Loops are unrolled whole where their count is a small constant, which frees arrays
// from local memory, and in no other way: copies of a loop's body would part what the source has as one
// branch.
std::vector<std::string> pinned_options() {
  return {"-x", "cl", "-cl-std=CL1.2", "-Xclang", extensions, "-Wno-linker-warnings", "-gdwarf-4",
          "-gline-directives-only", "-fdebug-compilation-dir=.", "-mllvm", "-unroll-runtime=false", "-mllvm",
          "-unroll-allow-partial=false",
          // Devices' compilers put every function in place.
          "-mllvm", "-inline-threshold=1000000"};
}

// Those that the code generator needs, too.
std::vector<std::string> code_options(bool exact_division) {
  return {"-target", "nvptx64-nvidia-nvcl", "-Xclang", "-target-cpu", "-Xclang", "sm_70", "-O2",
          "-fno-crash-diagnostics",
          // OpenCL's accuracy of float division, 2.5 ulp, lets it be div.full; else IEEE's.
          "-mllvm", exact_division ? "-nvptx-prec-divf32=2" : "-nvptx-prec-divf32=1", "-mllvm",
          exact_division ? "-nvptx-prec-sqrtf32=1" : "-nvptx-prec-sqrtf32=0"};
}

// `#line 1 "name"`, so that messages and line tables speak of the caller's file.
std::string named(std::string_view source, std::string_view name) {
  std::string text = "#line 1 \"";
  for (const char c : name) {
    if (c == '"' || c == '\\') text += '\\';
    text += c;
  }
  text += "\"\n";
  text += source;
  return text;
}

// clang's messages without the stack dump that follows an error in its back end.
std::string readable_errors(std::string text) {
  text.resize(std::min(text.size(), text.find("PLEASE submit a bug report")));
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

std::string failure_text(const ProcessResult& result) {
  const std::string text = readable_errors(result.errors);
  return text.empty() ? fmt::format("clang ended with status {}", result.exit_status) : text;
}

// The user's options behind `options`, and the folder where the source's #include "..." start from; so do the
// folders of -I.
void append_user_options(std::vector<std::string>& options, const std::vector<std::string>& user_options,
                         std::string_view source_name) {
  const std::filesystem::path folder_of_source = std::filesystem::path(source_name).parent_path();
  options.insert(options.end(), {"-iquote", folder_of_source.empty() ? "." : folder_of_source.string()});
  for (std::size_t i = 0; i < user_options.size(); ++i) {
    if (!user_options[i].starts_with("-I")) {
      options.push_back(user_options[i]);
      continue;
    }
    const std::string folder = user_options[i] == "-I" ? user_options[++i] : user_options[i].substr(2);
    options.push_back("-I" + (folder_of_source / folder).string());
  }
}

// Ours come first: what they define is not taken from libclc.
std::vector<std::string> library_options(const std::string& our_builtins) {
  const std::string option = "-mlink-builtin-bitcode";
  return {"-Xclang", option, "-Xclang", our_builtins, "-Xclang", option, "-Xclang", builtin_library()};
}

// What clang makes of the text, with the prelude before it.
std::string run_clang(std::string_view source, std::string_view source_name,
                      const std::vector<std::string>& options, bool with_libraries) {
  const TemporaryFolder folder;
  const std::string source_file = folder.path() / "kernel.cl";
  const std::string prelude_file = folder.path() / "prelude.cl";
  const std::string output_file = folder.path() / "kernel.out";
  write_text(source_file, named(source, source_name));
  write_text(prelude_file, embedded_preludes()[0].text);
  std::vector<std::string> arguments{compiler().program};
  arguments.insert(arguments.end(), options.begin(), options.end());
  if (with_libraries) {
    const std::string builtins_file = folder.path() / builtins_name;
    write_text(builtins_file, embedded_builtins());
    const std::vector<std::string> libraries = library_options(builtins_file);
    arguments.insert(arguments.end(), libraries.begin(), libraries.end());
  }
  arguments.insert(arguments.end(), {"-include", prelude_file, "-o", output_file, source_file});
  const ProcessResult result = run_process(arguments);
  if (result.exit_status != 0)
    throw InputError(fmt::format("{}: it does not compile\n{}", source_name, failure_text(result)));
  return read_text(output_file);
}

// clang 15 prints labels that nothing refers to, and some of them inside a call, where ptxas takes none.
std::string without_labels_in_calls(const std::string& ptx) {
  std::string text;
  std::istringstream lines(ptx);
  bool in_call = false;
  for (std::string line; std::getline(lines, line);) {
    if (in_call && line.starts_with("$L__tmp")) continue;
    in_call = line.starts_with("\tcall") && line.find(';') == std::string::npos;
    text += line;
    text += '\n';
  }
  return text;
}

// Whether initial values of variables stand in the PTX.
bool has_initial_values(std::string_view ptx) { return ptx.find("] = {") != std::string_view::npos; }

// The PTX of optimised bitcode: the code generator alone.
std::string generate_ptx(std::string_view bitcode, std::string_view source_name,
                         const std::vector<std::string>& options) {
  const TemporaryFolder folder;
  const std::string input_file = folder.path() / "kernel.bc";
  const std::string output_file = folder.path() / "kernel.ptx";
  write_text(input_file, bitcode);
  std::vector<std::string> arguments{compiler().program, "-x", "ir"};
  arguments.insert(arguments.end(), options.begin(), options.end());
  arguments.insert(arguments.end(), {"-Xclang", "-disable-llvm-passes", "-S", "-o", output_file, input_file});
  const ProcessResult result = run_process(arguments);
  if (result.exit_status != 0)
    throw InputError(fmt::format("{}: it does not compile\n{}", source_name, failure_text(result)));
  return read_text(output_file);
}

}  // namespace

CompiledPtx compile_opencl(std::string_view source, std::string_view source_name,
                           std::string_view build_options) {
  const std::vector<std::string> user_options = split_build_options(build_options);
  const bool exact_division = std::find(user_options.begin(), user_options.end(),
                                        "-cl-fp32-correctly-rounded-divide-sqrt") != user_options.end();
  const std::vector<std::string> of_code = code_options(exact_division);
  std::vector<std::string> options = pinned_options();
  options.insert(options.end(), of_code.begin(), of_code.end());
  if (exact_division) options.emplace_back("-DWARPGRAIN_EXACT_SQUARE_ROOT");
  // clang takes the option and does nothing of it for this target; NVIDIA's compiler flushes floats.
  if (std::ranges::find(user_options, "-cl-denorms-are-zero") != user_options.end())
    options.insert(options.end(), {"-Xclang", "-fdenormal-fp-math-f32=preserve-sign,preserve-sign"});
  append_user_options(options, user_options, source_name);

  CompiledPtx compiled;
  const auto compile_to = [&](std::initializer_list<const char*> output) {
    std::vector<std::string> all = options;
    all.insert(all.end(), output.begin(), output.end());
    return run_clang(source, source_name, all, true);
  };
  compiled.ptx = compile_to({"-S"});
  if (has_initial_values(compiled.ptx))
    if (const auto padded = pad_vectors_of_three(compile_to({"-emit-llvm", "-c"})))
      compiled.ptx = generate_ptx(*padded, source_name, of_code);
  compiled.ptx = without_labels_in_calls(compiled.ptx);
  if (std::ranges::find(user_options, smaller_groups_option) != user_options.end())
    compiled.ptx.insert(0, fmt::format("{}\n", smaller_groups_mark));
  compiled.compiler = compiler().version;
  compiled.command = fmt::format("clang {} -S {} -include opencl_prelude.cl", fmt::join(options, " "),
                                 fmt::join(library_options(builtins_name), " "));
  return compiled;
}

std::string declaration_bitcode(std::string_view source, std::string_view source_name,
                                std::string_view build_options) {
  std::vector<std::string> options{"-x",
                                   "cl",
                                   "-cl-std=CL1.2",
                                   "-target",
                                   "nvptx64-nvidia-nvcl",
                                   "-Xclang",
                                   extensions,
                                   "-cl-kernel-arg-info",
                                   "-w",
                                   "-Xclang",
                                   "-disable-llvm-passes",
                                   "-emit-llvm",
                                   "-c"};
  append_user_options(options, split_build_options(build_options), source_name);
  return run_clang(source, source_name, options, false);
}

std::vector<ParameterDeclaration> declared_parameters(std::string_view source, std::string_view source_name,
                                                      std::string_view build_options,
                                                      std::string_view kernel) {
  return parameters_in_bitcode(declaration_bitcode(source, source_name, build_options), kernel);
}

}  // namespace warpgrain::profiler
