// The OpenCL layer of `warpgrain record`: the loader calls these functions in place of the driver's, and they
// call the driver's. https://registry.khronos.org/OpenCL/specs/3.0-unified/html/OpenCL_Ext.html,
// cl_loader_layers

#include <CL/cl_layer.h>
#include <cstring>

#include "cli/layer/recorder.hpp"
#include "cli/layer/watched_calls.hpp"
#include "cli/record_settings.hpp"

namespace {

cl_int answer(const void* value, size_t size, size_t room, void* to, size_t* size_of_answer) {
  if (to != nullptr && room < size) return CL_INVALID_VALUE;
  if (to != nullptr) std::memcpy(to, value, size);
  if (size_of_answer != nullptr) *size_of_answer = size;
  return CL_SUCCESS;
}

}  // namespace

extern "C" {

__attribute__((visibility("default"))) cl_int CL_API_CALL clGetLayerInfo(cl_layer_info what, size_t room,
                                                                         void* to, size_t* size) {
  static constexpr cl_layer_api_version version = CL_LAYER_API_VERSION_100;
  static constexpr char name[] = "warpgrain record";
  if (what == CL_LAYER_API_VERSION) return answer(&version, sizeof version, room, to, size);
  if (what == CL_LAYER_NAME) return answer(name, sizeof name, room, to, size);
  return CL_INVALID_VALUE;
}

__attribute__((visibility("default"))) cl_int CL_API_CALL clInitLayer(cl_uint n_entries,
                                                                      const cl_icd_dispatch* target,
                                                                      cl_uint* n_ours,
                                                                      const cl_icd_dispatch** ours) {
  constexpr cl_uint n_functions = sizeof(cl_icd_dispatch) / sizeof(void*);
  if (target == nullptr || n_ours == nullptr || ours == nullptr || n_entries < n_functions)
    return CL_INVALID_VALUE;
  static cl_icd_dispatch table;
  warpgrain::layer::driver = *target;
  table = *target;
  const warpgrain::cli::RecordSettings settings = warpgrain::cli::settings_of_environment();
  if (!settings.folder.empty()) {
    warpgrain::layer::recorder = new warpgrain::layer::Recorder(warpgrain::layer::driver, settings);
    warpgrain::layer::watch_memory(table);
    warpgrain::layer::watch_programs(table);
    warpgrain::layer::watch_kernels(table);
    warpgrain::layer::watch_launches(table);
  }
  *ours = &table;
  *n_ours = n_functions;
  return CL_SUCCESS;
}

}  // extern "C"
