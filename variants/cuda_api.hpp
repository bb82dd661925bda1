#pragma once
// The entry points of CUDA's driver, libcuda.so.1, opened at run time: building needs no CUDA, and the same
// program runs where there is none. Names, numbers and types as in NVIDIA's "CUDA Driver API" reference.

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace warpgrain {

// CUresult, 0 for success, and the handles, which are opaque.
using CudaResult = int;
using CudaDeviceNumber = int;
using CudaAddress = std::uint64_t;
using CudaHandle = struct CudaOpaque*;

struct CudaApi {
  CudaResult (*init)(unsigned flags);
  CudaResult (*driver_version)(int* version);
  CudaResult (*device_count)(int* count);
  CudaResult (*device_get)(CudaDeviceNumber* device, int ordinal);
  CudaResult (*device_name)(char* name, int length, CudaDeviceNumber device);
  CudaResult (*device_attribute)(int* value, int attribute, CudaDeviceNumber device);
  CudaResult (*primary_context_retain)(CudaHandle* context, CudaDeviceNumber device);
  CudaResult (*primary_context_release)(CudaDeviceNumber device);
  CudaResult (*context_set_current)(CudaHandle context);
  CudaResult (*context_synchronize)();
  CudaResult (*memory_allocate)(CudaAddress* address, std::size_t bytes);
  CudaResult (*memory_free)(CudaAddress address);
  CudaResult (*copy_to_device)(CudaAddress to, const void* from, std::size_t bytes);
  CudaResult (*copy_to_host)(void* to, CudaAddress from, std::size_t bytes);
  CudaResult (*copy_on_device)(CudaAddress to, CudaAddress from, std::size_t bytes);
  CudaResult (*fill_bytes)(CudaAddress to, unsigned char value, std::size_t bytes);
  CudaResult (*module_load)(CudaHandle* module, const void* image, unsigned n_options, int* options,
                            void** values);
  CudaResult (*module_unload)(CudaHandle module);
  CudaResult (*module_function)(CudaHandle* function, CudaHandle module, const char* name);
  CudaResult (*function_attribute)(int* value, int attribute, CudaHandle function);
  CudaResult (*function_set_attribute)(CudaHandle function, int attribute, int value);
  CudaResult (*launch)(CudaHandle function, unsigned grid_x, unsigned grid_y, unsigned grid_z,
                       unsigned block_x, unsigned block_y, unsigned block_z, unsigned shared_bytes,
                       CudaHandle stream, void** parameters, void** extra);
  CudaResult (*event_create)(CudaHandle* event, unsigned flags);
  CudaResult (*event_record)(CudaHandle event, CudaHandle stream);
  CudaResult (*event_synchronize)(CudaHandle event);
  CudaResult (*event_elapsed)(float* milliseconds, CudaHandle begin, CudaHandle end);
  CudaResult (*event_destroy)(CudaHandle event);
  CudaResult (*profiler_start)();
  CudaResult (*profiler_stop)();
  CudaResult (*error_name)(CudaResult result, const char** name);
  CudaResult (*error_text)(CudaResult result, const char** text);
};

// Empty when there is a driver and a device; else what is missing, in one line.
std::string cuda_lacks();

// The driver, initialised. Throws InputError with cuda_lacks().
const CudaApi& cuda_api();

// Throws InputError "WHERE: CALL failed with CUDA_ERROR_...: text" unless `result` is success.
void check_cuda(CudaResult result, std::string_view where, std::string_view call);

}  // namespace warpgrain
