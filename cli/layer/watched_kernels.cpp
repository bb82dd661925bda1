// Kernels and what is set as their arguments.

#include <cstring>
#include <string>

#include "cli/layer/watched_calls.hpp"

namespace warpgrain::layer {
namespace {

std::string name_of(cl_kernel kernel) {
  size_t size = 0;
  if (driver.clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, 0, nullptr, &size) != CL_SUCCESS || size == 0)
    return "?";
  std::string name(size, '\0');
  driver.clGetKernelInfo(kernel, CL_KERNEL_FUNCTION_NAME, size, name.data(), nullptr);
  name.resize(std::strlen(name.c_str()));
  return name;
}

cl_kernel CL_API_CALL create_kernel(cl_program program, const char* name, cl_int* error) {
  const cl_kernel kernel = driver.clCreateKernel(program, name, error);
  if (kernel != nullptr)
    noting([&] { recorder->kernels.add(kernel, recorder->programs.text_of(program), name); });
  return kernel;
}

cl_int CL_API_CALL create_kernels(cl_program program, cl_uint room, cl_kernel* kernels, cl_uint* count) {
  cl_uint n_kernels = 0;
  const cl_int status = driver.clCreateKernelsInProgram(program, room, kernels, &n_kernels);
  if (count != nullptr) *count = n_kernels;
  if (status == CL_SUCCESS && kernels != nullptr)
    for (cl_uint i = 0; i < n_kernels; ++i)
      noting([&] {
        recorder->kernels.add(kernels[i], recorder->programs.text_of(program), name_of(kernels[i]));
      });
  return status;
}

cl_kernel CL_API_CALL clone_kernel(cl_kernel source, cl_int* error) {
  const cl_kernel kernel = driver.clCloneKernel(source, error);
  if (kernel != nullptr) noting([&] { recorder->kernels.clone(kernel, source); });
  return kernel;
}

void retain_kernel(cl_kernel kernel) { recorder->kernels.retain(kernel); }
void release_kernel(cl_kernel kernel) { recorder->kernels.release(kernel); }

// What a parameter is follows from what may be said of it: NULL is no value of a number, and local memory has
// no value. clGetKernelArgInfo knows only where the program was built with an option for it.
Parameter ask_parameter(cl_kernel kernel, cl_uint index) {
  static constexpr cl_mem no_memory = nullptr;
  if (driver.clSetKernelArg(kernel, index, sizeof no_memory, nullptr) != CL_SUCCESS) return Parameter::value;
  return driver.clSetKernelArg(kernel, index, sizeof no_memory, &no_memory) == CL_SUCCESS ? Parameter::pointer
                                                                                          : Parameter::local;
}

cl_int CL_API_CALL set_argument(cl_kernel kernel, cl_uint index, size_t size, const void* value) {
  noting([&] {
    if (recorder->kernels.is_unclear(kernel, index, size, value))
      recorder->kernels.set_parameter(kernel, index, ask_parameter(kernel, index));
  });
  const cl_int status = driver.clSetKernelArg(kernel, index, size, value);
  if (status == CL_SUCCESS) noting([&] { recorder->kernels.set(kernel, index, size, value); });
  return status;
}

cl_int CL_API_CALL set_shared_argument(cl_kernel kernel, cl_uint index, const void* value) {
  const cl_int status = driver.clSetKernelArgSVMPointer(kernel, index, value);
  if (status == CL_SUCCESS) noting([&] { recorder->kernels.set_shared_virtual_memory(kernel, index); });
  return status;
}

cl_int CL_API_CALL set_execution_info(cl_kernel kernel, cl_kernel_exec_info what, size_t size,
                                      const void* value) {
  const cl_int status = driver.clSetKernelExecInfo(kernel, what, size, value);
  if (status == CL_SUCCESS && what == CL_KERNEL_EXEC_INFO_SVM_PTRS)
    noting([&] { recorder->kernels.use_shared_virtual_memory(kernel); });
  return status;
}

}  // namespace

void watch_kernels(cl_icd_dispatch& table) {
  table.clCreateKernel = create_kernel;
  table.clCreateKernelsInProgram = create_kernels;
  table.clCloneKernel = clone_kernel;
  table.clRetainKernel = noted_first<&cl_icd_dispatch::clRetainKernel, retain_kernel>;
  table.clReleaseKernel = noted_first<&cl_icd_dispatch::clReleaseKernel, release_kernel>;
  table.clSetKernelArg = set_argument;
  table.clSetKernelArgSVMPointer = set_shared_argument;
  table.clSetKernelExecInfo = set_execution_info;
}

}  // namespace warpgrain::layer
