#include "variants/cuda_api.hpp"

#include <dlfcn.h>
#include <fmt/format.h>
#include <optional>

#include "core/error.hpp"

namespace warpgrain {
namespace {

struct Opened {
  CudaApi api{};
  std::string lacks;  // empty: it can be used
};

std::string error_of(const CudaApi& api, CudaResult result) {
  const char *name = nullptr, *text = nullptr;
  if (api.error_name(result, &name) != 0 || name == nullptr) return fmt::format("CUDA error {}", result);
  if (api.error_text(result, &text) != 0 || text == nullptr) return name;
  return fmt::format("{} ({})", name, text);
}

// The first name that the library does not have; empty when it has all.
std::string find_entry_points(void* library, CudaApi& api) {
  std::string missing;
  const auto find = [&](auto& function, const char* name) {
    void* const symbol = dlsym(library, name);
    if (symbol == nullptr && missing.empty()) missing = name;
    function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(symbol);
  };
  find(api.init, "cuInit");
  find(api.driver_version, "cuDriverGetVersion");
  find(api.device_count, "cuDeviceGetCount");
  find(api.device_get, "cuDeviceGet");
  find(api.device_name, "cuDeviceGetName");
  find(api.device_attribute, "cuDeviceGetAttribute");
  find(api.primary_context_retain, "cuDevicePrimaryCtxRetain");
  find(api.primary_context_release, "cuDevicePrimaryCtxRelease_v2");
  find(api.context_set_current, "cuCtxSetCurrent");
  find(api.context_synchronize, "cuCtxSynchronize");
  find(api.memory_allocate, "cuMemAlloc_v2");
  find(api.memory_free, "cuMemFree_v2");
  find(api.copy_to_device, "cuMemcpyHtoD_v2");
  find(api.copy_to_host, "cuMemcpyDtoH_v2");
  find(api.copy_on_device, "cuMemcpyDtoD_v2");
  find(api.fill_bytes, "cuMemsetD8_v2");
  find(api.module_load, "cuModuleLoadDataEx");
  find(api.module_unload, "cuModuleUnload");
  find(api.module_function, "cuModuleGetFunction");
  find(api.function_attribute, "cuFuncGetAttribute");
  find(api.function_set_attribute, "cuFuncSetAttribute");
  find(api.launch, "cuLaunchKernel");
  find(api.event_create, "cuEventCreate");
  find(api.event_record, "cuEventRecord");
  find(api.event_synchronize, "cuEventSynchronize");
  find(api.event_elapsed, "cuEventElapsedTime");
  find(api.event_destroy, "cuEventDestroy_v2");
  find(api.profiler_start, "cuProfilerStart");
  find(api.profiler_stop, "cuProfilerStop");
  find(api.error_name, "cuGetErrorName");
  find(api.error_text, "cuGetErrorString");
  return missing;
}

// The library stays open: it has threads of its own.
Opened open_driver() {
  Opened opened;
  void* const library = dlopen("libcuda.so.1", RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    opened.lacks = "no CUDA driver: libcuda.so.1 cannot be opened; it comes with NVIDIA's driver";
    return opened;
  }
  if (const std::string missing = find_entry_points(library, opened.api); !missing.empty()) {
    opened.lacks = fmt::format("the CUDA driver is too old: libcuda.so.1 has no {}", missing);
    return opened;
  }
  if (const CudaResult result = opened.api.init(0); result != 0) {
    opened.lacks =
        fmt::format("the CUDA driver does not start: cuInit gives {}", error_of(opened.api, result));
    return opened;
  }
  int count = 0;
  if (opened.api.device_count(&count) != 0 || count == 0) opened.lacks = "the CUDA driver finds no device";
  return opened;
}

const Opened& opened() {
  static const Opened driver = open_driver();
  return driver;
}

}  // namespace

std::string cuda_lacks() { return opened().lacks; }

const CudaApi& cuda_api() {
  if (!opened().lacks.empty()) throw_input_error("cuda", opened().lacks);
  return opened().api;
}

void check_cuda(CudaResult result, std::string_view where, std::string_view call) {
  if (result != 0)
    throw_input_error(where, fmt::format("{} failed with {}", call, error_of(opened().api, result)));
}

}  // namespace warpgrain
