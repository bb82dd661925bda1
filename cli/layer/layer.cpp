// The OpenCL layer of `warpgrain record`: the loader calls these functions in place of the driver's, and they
// call the driver's. https://registry.khronos.org/OpenCL/specs/3.0-unified/html/OpenCL_Ext.html,
// cl_loader_layers

#include <CL/cl_layer.h>
#include <array>
#include <cstring>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "cli/layer/recorder.hpp"
#include "cli/record_settings.hpp"

namespace {

using warpgrain::layer::Enqueued;
using warpgrain::layer::PendingLaunch;
using warpgrain::layer::Recorder;

// Set once, before any of the functions below can be called. The recorder is never destroyed: applications
// use OpenCL until their very end.
cl_icd_dispatch driver;
Recorder* recorder = nullptr;

// What is noted of a call must not stop the application.
template <typename Function>
void noting(Function&& function) noexcept {
  try {
    function();
  } catch (...) {
    // Without memory for the note the object stays unknown, and launches that use it are not recorded.
  }
}

// A function of the driver that makes a memory object or a sampler.
template <auto member, class Type = decltype(member)>
struct Makes;
template <auto member, class Handle, class... Arguments>
struct Makes<member, Handle (*cl_icd_dispatch::*)(Arguments...)> {
  static Handle CL_API_CALL call(Arguments... arguments) {
    const Handle handle = (driver.*member)(arguments...);
    if (handle != nullptr) noting([&] { recorder->handles.add(handle); });
    return handle;
  }
};

// One that makes a program without a source.
template <auto member, class Type = decltype(member)>
struct MakesUnknown;
template <auto member, class... Arguments>
struct MakesUnknown<member, cl_program (*cl_icd_dispatch::*)(Arguments...)> {
  static cl_program CL_API_CALL call(Arguments... arguments) {
    const cl_program program = (driver.*member)(arguments...);
    if (program != nullptr) noting([&] { recorder->programs.add_unknown(program, why()); });
    return program;
  }
  static const char* why() {
    if constexpr (std::is_same_v<decltype(member), decltype(&cl_icd_dispatch::clCreateProgramWithIL)>)
      return "a program made from SPIR-V";
    else if constexpr (std::is_same_v<decltype(member),
                                      decltype(&cl_icd_dispatch::clCreateProgramWithBuiltInKernels)>)
      return "a kernel built into the device";
    else
      return "a program made from a binary";
  }
};

cl_int CL_API_CALL retain_memory(cl_mem memory) {
  noting([&] { recorder->handles.retain(memory); });
  return driver.clRetainMemObject(memory);
}

// Released here first: behind the driver's release another thread may get a new object of the same handle.
cl_int CL_API_CALL release_memory(cl_mem memory) {
  noting([&] { recorder->handles.release(memory); });
  return driver.clReleaseMemObject(memory);
}

cl_int CL_API_CALL retain_sampler(cl_sampler sampler) {
  noting([&] { recorder->handles.retain(sampler); });
  return driver.clRetainSampler(sampler);
}

cl_int CL_API_CALL release_sampler(cl_sampler sampler) {
  noting([&] { recorder->handles.release(sampler); });
  return driver.clReleaseSampler(sampler);
}

cl_program CL_API_CALL create_program(cl_context context, cl_uint count, const char** strings,
                                      const size_t* lengths, cl_int* error) {
  const cl_program program = driver.clCreateProgramWithSource(context, count, strings, lengths, error);
  if (program == nullptr) return program;
  noting([&] {
    std::string source;
    for (cl_uint i = 0; i < count; ++i)
      source += lengths != nullptr && lengths[i] != 0 ? std::string_view(strings[i], lengths[i])
                                                      : std::string_view(strings[i]);
    recorder->programs.add_source(program, std::move(source));
  });
  return program;
}

cl_int CL_API_CALL retain_program(cl_program program) {
  noting([&] { recorder->programs.retain(program); });
  return driver.clRetainProgram(program);
}

cl_int CL_API_CALL release_program(cl_program program) {
  noting([&] { recorder->programs.release(program); });
  return driver.clReleaseProgram(program);
}

// Noted before the driver builds: it may call back, or build in the background.
cl_int CL_API_CALL build_program(cl_program program, cl_uint n_devices, const cl_device_id* devices,
                                 const char* options, void(CL_CALLBACK* notify)(cl_program, void*),
                                 void* data) {
  noting([&] { recorder->programs.build(program, options); });
  return driver.clBuildProgram(program, n_devices, devices, options, notify, data);
}

cl_int CL_API_CALL compile_program(cl_program program, cl_uint n_devices, const cl_device_id* devices,
                                   const char* options, cl_uint n_headers, const cl_program* headers,
                                   const char** names, void(CL_CALLBACK* notify)(cl_program, void*),
                                   void* data) {
  noting([&] {
    const std::vector<cl_program> given(headers, headers + (headers != nullptr ? n_headers : 0));
    recorder->programs.compile(program, options, given, names);
  });
  return driver.clCompileProgram(program, n_devices, devices, options, n_headers, headers, names, notify,
                                 data);
}

cl_program CL_API_CALL link_program(cl_context context, cl_uint n_devices, const cl_device_id* devices,
                                    const char* options, cl_uint n_inputs, const cl_program* inputs,
                                    void(CL_CALLBACK* notify)(cl_program, void*), void* data, cl_int* error) {
  const cl_program program =
      driver.clLinkProgram(context, n_devices, devices, options, n_inputs, inputs, notify, data, error);
  if (program != nullptr) noting([&] { recorder->programs.link(program, {inputs, inputs + n_inputs}); });
  return program;
}

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

cl_int CL_API_CALL retain_kernel(cl_kernel kernel) {
  noting([&] { recorder->kernels.retain(kernel); });
  return driver.clRetainKernel(kernel);
}

cl_int CL_API_CALL release_kernel(cl_kernel kernel) {
  noting([&] { recorder->kernels.release(kernel); });
  return driver.clReleaseKernel(kernel);
}

// What a parameter is follows from what may be said of it: NULL is no value of a number, and local memory has
// no value. clGetKernelArgInfo knows only where the program was built with an option for it.
warpgrain::layer::Parameter ask_parameter(cl_kernel kernel, cl_uint index) {
  using warpgrain::layer::Parameter;
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

cl_event CL_API_CALL create_user_event(cl_context context, cl_int* error) {
  const cl_event event = driver.clCreateUserEvent(context, error);
  if (event != nullptr) recorder->user_event_made();
  return event;
}

cl_int CL_API_CALL set_user_event(cl_event event, cl_int execution_status) {
  const cl_int status = driver.clSetUserEventStatus(event, execution_status);
  if (status == CL_SUCCESS) recorder->user_event_set();
  return status;
}

// `start` lets the launch go its way.
template <typename Start>
cl_int record(const Enqueued& launch, Start&& start) {
  const std::optional<PendingLaunch> pending = recorder->capture(launch);
  const cl_int status = start();
  if (pending && status == CL_SUCCESS) recorder->keep(*pending);
  return status;
}

cl_int CL_API_CALL enqueue_kernel(cl_command_queue queue, cl_kernel kernel, cl_uint dimensions,
                                  const size_t* offset, const size_t* global_size, const size_t* local_size,
                                  cl_uint n_wait, const cl_event* wait_list, cl_event* event) {
  return record({queue, kernel, dimensions, offset, global_size, local_size, n_wait, wait_list}, [&] {
    return driver.clEnqueueNDRangeKernel(queue, kernel, dimensions, offset, global_size, local_size, n_wait,
                                         wait_list, event);
  });
}

cl_int CL_API_CALL enqueue_task(cl_command_queue queue, cl_kernel kernel, cl_uint n_wait,
                                const cl_event* wait_list, cl_event* event) {
  static constexpr size_t one = 1;
  return record({queue, kernel, 1, nullptr, &one, &one, n_wait, wait_list},
                [&] { return driver.clEnqueueTask(queue, kernel, n_wait, wait_list, event); });
}

template <auto... members>
void watch_making(cl_icd_dispatch& table) {
  ((table.*members = Makes<members>::call), ...);
}

cl_icd_dispatch watched_table() {
  using Table = cl_icd_dispatch;
  Table table = driver;
  watch_making<&Table::clCreateBuffer, &Table::clCreateBufferWithProperties, &Table::clCreateSubBuffer,
               &Table::clCreateImage, &Table::clCreateImage2D, &Table::clCreateImage3D,
               &Table::clCreateImageWithProperties, &Table::clCreatePipe, &Table::clCreateFromGLBuffer,
               &Table::clCreateFromGLTexture2D, &Table::clCreateFromGLTexture3D,
               &Table::clCreateFromGLTexture, &Table::clCreateFromGLRenderbuffer, &Table::clCreateSampler,
               &Table::clCreateSamplerWithProperties>(table);
  table.clRetainMemObject = retain_memory;
  table.clReleaseMemObject = release_memory;
  table.clRetainSampler = retain_sampler;
  table.clReleaseSampler = release_sampler;
  table.clCreateProgramWithSource = create_program;
  table.clCreateProgramWithBinary = MakesUnknown<&Table::clCreateProgramWithBinary>::call;
  table.clCreateProgramWithBuiltInKernels = MakesUnknown<&Table::clCreateProgramWithBuiltInKernels>::call;
  table.clCreateProgramWithIL = MakesUnknown<&Table::clCreateProgramWithIL>::call;
  table.clRetainProgram = retain_program;
  table.clReleaseProgram = release_program;
  table.clBuildProgram = build_program;
  table.clCompileProgram = compile_program;
  table.clLinkProgram = link_program;
  table.clCreateKernel = create_kernel;
  table.clCreateKernelsInProgram = create_kernels;
  table.clCloneKernel = clone_kernel;
  table.clRetainKernel = retain_kernel;
  table.clReleaseKernel = release_kernel;
  table.clSetKernelArg = set_argument;
  table.clSetKernelArgSVMPointer = set_shared_argument;
  table.clSetKernelExecInfo = set_execution_info;
  table.clCreateUserEvent = create_user_event;
  table.clSetUserEventStatus = set_user_event;
  table.clEnqueueNDRangeKernel = enqueue_kernel;
  table.clEnqueueTask = enqueue_task;
  return table;
}

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
  driver = *target;
  table = driver;
  const warpgrain::cli::RecordSettings settings = warpgrain::cli::settings_of_environment();
  if (!settings.folder.empty()) {
    recorder = new Recorder(driver, settings);
    table = watched_table();
  }
  *ours = &table;
  *n_ours = n_functions;
  return CL_SUCCESS;
}

}  // extern "C"
