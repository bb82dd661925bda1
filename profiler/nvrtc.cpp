#include "profiler/nvrtc.hpp"

#include <dlfcn.h>
#include <fmt/format.h>

namespace warpgrain::profiler {
namespace {

// As nvrtc.h declares them; its types are opaque pointers and enumerations that are 0 for success.
using Program = void*;
using CreateProgram = int (*)(Program*, const char*, const char*, int, const char* const*,
                              const char* const*);
using CompileProgram = int (*)(Program, int, const char* const*);
using GetSize = int (*)(Program, std::size_t*);
using GetText = int (*)(Program, char*);
using DestroyProgram = int (*)(Program*);
using Version = int (*)(int*, int*);

void* open_library() {
  for (const char* name : {"libnvrtc.so", "libnvrtc.so.13", "libnvrtc.so.12", "libnvrtc.so.11.2",
                           "/usr/local/cuda/lib64/libnvrtc.so"})
    if (void* library = dlopen(name, RTLD_NOW | RTLD_LOCAL)) return library;
  return nullptr;
}

class Nvrtc {
 public:
  explicit Nvrtc(void* library)
      : create(find<CreateProgram>(library, "nvrtcCreateProgram")),
        compile(find<CompileProgram>(library, "nvrtcCompileProgram")),
        ptx_size(find<GetSize>(library, "nvrtcGetPTXSize")),
        ptx(find<GetText>(library, "nvrtcGetPTX")),
        log_size(find<GetSize>(library, "nvrtcGetProgramLogSize")),
        log(find<GetText>(library, "nvrtcGetProgramLog")),
        destroy(find<DestroyProgram>(library, "nvrtcDestroyProgram")),
        version(find<Version>(library, "nvrtcVersion")) {}

  bool is_whole() const {
    return create && compile && ptx_size && ptx && log_size && log && destroy && version;
  }

  const CreateProgram create;
  const CompileProgram compile;
  const GetSize ptx_size;
  const GetText ptx;
  const GetSize log_size;
  const GetText log;
  const DestroyProgram destroy;
  const Version version;

 private:
  template <class Function>
  static Function find(void* library, const char* name) {
    return reinterpret_cast<Function>(dlsym(library, name));
  }
};

// A text that the library hands out with its terminating NUL.
std::string text_of(Program program, GetSize size, GetText get) {
  std::size_t bytes = 0;
  if (size(program, &bytes) != 0 || bytes == 0) return {};
  std::string text(bytes, '\0');
  if (get(program, text.data()) != 0) return {};
  while (!text.empty() && text.back() == '\0') text.pop_back();
  return text;
}

}  // namespace

std::optional<NvrtcResult> compile_with_nvrtc(const std::string& source, const std::string& name,
                                              const std::vector<std::string>& options) {
  // Stays open: the library keeps threads of its own.
  static void* const library = open_library();
  if (library == nullptr) return std::nullopt;
  const Nvrtc nvrtc(library);
  if (!nvrtc.is_whole()) return std::nullopt;
  NvrtcResult result;
  int major = 0, minor = 0;
  nvrtc.version(&major, &minor);
  result.version = fmt::format("NVRTC {}.{}", major, minor);
  Program program = nullptr;
  if (nvrtc.create(&program, source.c_str(), name.c_str(), 0, nullptr, nullptr) != 0) {
    result.log = "nvrtcCreateProgram failed";
    return result;
  }
  std::vector<const char*> texts;
  texts.reserve(options.size());
  for (const std::string& option : options) texts.push_back(option.c_str());
  const bool compiles = nvrtc.compile(program, static_cast<int>(texts.size()), texts.data()) == 0;
  result.log = text_of(program, nvrtc.log_size, nvrtc.log);
  if (compiles) result.ptx = text_of(program, nvrtc.ptx_size, nvrtc.ptx);
  nvrtc.destroy(&program);
  return result;
}

}  // namespace warpgrain::profiler
