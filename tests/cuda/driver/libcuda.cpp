// A libcuda.so.1 for tests: host memory in place of a device's, and kernels run by whoever loads it, through
// `warpgrain_test_launch`. Only what a launch needs, and no more strict than these tests are.

#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>

extern "C" {

// Runs one launch of PTX; what cuLaunchKernel takes. 0: it ran.
int warpgrain_test_launch(const char* ptx, const char* kernel, const unsigned* groups,
                          const unsigned* group_size, unsigned shared_bytes, void** parameters);

namespace {

constexpr int invalid_value = 1, invalid_image = 200, not_found = 500, launch_failed = 719;

struct Module {
  std::string ptx;
};
struct Function {
  Module* module;
  std::string name;
};
struct Event {
  std::chrono::steady_clock::time_point time;
};

}  // namespace

int cuInit(unsigned) { return 0; }
int cuDriverGetVersion(int* version) { return *version = 13000, 0; }
int cuDeviceGetCount(int* count) { return *count = 1, 0; }
int cuDeviceGet(int* device, int) { return *device = 0, 0; }
int cuDeviceGetName(char* name, int length, int) {
  std::strncpy(name, "Test device", static_cast<std::size_t>(length));
  return 0;
}
int cuDeviceGetAttribute(int* value, int attribute, int) { return *value = attribute == 75 ? 9 : 0, 0; }
int cuDevicePrimaryCtxRetain(void** context, int) { return *context = nullptr, 0; }
int cuDevicePrimaryCtxRelease_v2(int) { return 0; }
int cuCtxSetCurrent(void*) { return 0; }
int cuCtxSynchronize() { return 0; }

int cuMemAlloc_v2(std::uint64_t* address, std::size_t bytes) {
  if (bytes > std::size_t{1} << 40) return 2;
  *address = reinterpret_cast<std::uint64_t>(std::aligned_alloc(256, (bytes + 255) / 256 * 256));
  return 0;
}
int cuMemFree_v2(std::uint64_t address) { return std::free(reinterpret_cast<void*>(address)), 0; }
int cuMemcpyHtoD_v2(std::uint64_t to, const void* from, std::size_t bytes) {
  return std::memcpy(reinterpret_cast<void*>(to), from, bytes), 0;
}
int cuMemcpyDtoH_v2(void* to, std::uint64_t from, std::size_t bytes) {
  return std::memcpy(to, reinterpret_cast<const void*>(from), bytes), 0;
}
int cuMemcpyDtoD_v2(std::uint64_t to, std::uint64_t from, std::size_t bytes) {
  return std::memcpy(reinterpret_cast<void*>(to), reinterpret_cast<const void*>(from), bytes), 0;
}
int cuMemsetD8_v2(std::uint64_t to, unsigned char value, std::size_t bytes) {
  return std::memset(reinterpret_cast<void*>(to), value, bytes), 0;
}

int cuModuleLoadDataEx(void** module, const void* image, unsigned n_options, const int* options,
                       void** values) {
  const char* const text = static_cast<const char*>(image);
  if (std::strstr(text, "texmode_independent") == nullptr && std::strstr(text, ".version") != nullptr)
    return *module = new Module{text}, 0;
  for (unsigned k = 0; k < n_options; ++k)
    if (options[k] == 5) std::strcpy(static_cast<char*>(values[k]), "test driver: not PTX for CUDA\n");
  return invalid_image;
}
int cuModuleUnload(void* module) { return delete static_cast<Module*>(module), 0; }
int cuModuleGetFunction(void** function, void* module, const char* name) {
  auto* const loaded = static_cast<Module*>(module);
  if (loaded->ptx.find(".entry " + std::string(name) + "(") == std::string::npos) return not_found;
  static Function functions[64];  // live as long as the program, as handles of unloaded modules do
  static unsigned next = 0;
  functions[next % 64] = {loaded, name};
  return *function = &functions[next++ % 64], 0;
}
int cuFuncGetAttribute(int* value, int attribute, void*) {
  const int values[] = {1024, 0, 0, 16, 20};
  return *value = values[attribute], 0;
}
int cuFuncSetAttribute(void*, int, int) { return 0; }

int cuLaunchKernel(void* function, unsigned grid_x, unsigned grid_y, unsigned grid_z, unsigned block_x,
                   unsigned block_y, unsigned block_z, unsigned shared_bytes, void*, void** parameters,
                   void**) {
  const auto* const kernel = static_cast<Function*>(function);
  if (kernel->name == "warpgrain_delay") return 0;
  if (grid_x == 0 || block_x == 0) return invalid_value;
  const unsigned groups[] = {grid_x, grid_y, grid_z}, group_size[] = {block_x, block_y, block_z};
  const int result = warpgrain_test_launch(kernel->module->ptx.c_str(), kernel->name.c_str(), groups,
                                           group_size, shared_bytes, parameters);
  return result == 0 ? 0 : launch_failed;
}

int cuEventCreate(void** event, unsigned) { return *event = new Event, 0; }
int cuEventRecord(void* event, void*) {
  return static_cast<Event*>(event)->time = std::chrono::steady_clock::now(), 0;
}
int cuEventSynchronize(void*) { return 0; }
int cuEventElapsedTime(float* milliseconds, void* begin, void* end) {
  *milliseconds = std::chrono::duration<float, std::milli>(static_cast<Event*>(end)->time -
                                                           static_cast<Event*>(begin)->time)
                      .count();
  return 0;
}
int cuEventDestroy_v2(void* event) { return delete static_cast<Event*>(event), 0; }

int cuProfilerStart() { return 0; }
int cuProfilerStop() { return 0; }

int cuGetErrorName(int result, const char** name) {
  *name = result == invalid_image ? "CUDA_ERROR_INVALID_IMAGE"
          : result == not_found   ? "CUDA_ERROR_NOT_FOUND"
                                  : "CUDA_ERROR_OTHER";
  return 0;
}
int cuGetErrorString(int, const char** text) { return *text = "as the test has it", 0; }

}  // extern "C"
