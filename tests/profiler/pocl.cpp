#include "tests/profiler/pocl.hpp"

#define CL_TARGET_OPENCL_VERSION 120
#include <CL/cl.h>
#include <array>
#include <stdexcept>

namespace warpgrain::profiler {
namespace {

void check(cl_int status, const char* what) {
  if (status != CL_SUCCESS)
    throw std::runtime_error(std::string(what) + " returned " + std::to_string(status));
}

cl_platform_id find_platform() {
  std::array<cl_platform_id, 16> platforms{};
  cl_uint count = 0;
  check(clGetPlatformIDs(platforms.size(), platforms.data(), &count), "clGetPlatformIDs");
  for (cl_uint i = 0; i < count; ++i) {
    std::array<char, 256> name{};
    check(clGetPlatformInfo(platforms[i], CL_PLATFORM_NAME, name.size() - 1, name.data(), nullptr),
          "clGetPlatformInfo");
    if (std::string(name.data()) == "Portable Computing Language") return platforms[i];
  }
  throw std::runtime_error("no PoCL among the OpenCL platforms");
}

}  // namespace

struct Pocl::State {
  std::string options;
  cl_device_id device = nullptr;
  cl_context context = nullptr;
  cl_command_queue queue = nullptr;
  cl_program program = nullptr;  // the last one that was built
  std::string source;

  // Several kernels of one text are built once.
  void build(const std::string& text) {
    if (program != nullptr && source == text) return;
    release_program();
    cl_int status = 0;
    const char* characters = text.c_str();
    program = clCreateProgramWithSource(context, 1, &characters, nullptr, &status);
    check(status, "clCreateProgramWithSource");
    check(clBuildProgram(program, 1, &device, options.c_str(), nullptr, nullptr), "clBuildProgram");
    source = text;
  }
  void release_program() {
    if (program != nullptr) clReleaseProgram(program);
    program = nullptr;
  }
};

Pocl::Pocl(std::string options) : state_(std::make_unique<State>()) {
  state_->options = std::move(options);
  check(clGetDeviceIDs(find_platform(), CL_DEVICE_TYPE_ALL, 1, &state_->device, nullptr), "clGetDeviceIDs");
  cl_int status = 0;
  state_->context = clCreateContext(nullptr, 1, &state_->device, nullptr, nullptr, &status);
  check(status, "clCreateContext");
  state_->queue = clCreateCommandQueue(state_->context, state_->device, 0, &status);
  check(status, "clCreateCommandQueue");
}

Pocl::~Pocl() {
  state_->release_program();
  clReleaseCommandQueue(state_->queue);
  clReleaseContext(state_->context);
}

void Pocl::run(const std::string& source, const std::string& kernel_name, const LaunchShape& shape,
               const std::vector<KernelArgument>& arguments) {
  state_->build(source);
  cl_int status = 0;
  cl_kernel kernel = clCreateKernel(state_->program, kernel_name.c_str(), &status);
  check(status, "clCreateKernel");
  std::vector<cl_mem> buffers(arguments.size());
  for (cl_uint i = 0; i < arguments.size(); ++i) {
    const KernelArgument& argument = arguments[i];
    if (argument.kind == KernelArgument::Kind::buffer) {
      buffers[i] = clCreateBuffer(state_->context, CL_MEM_READ_WRITE | CL_MEM_COPY_HOST_PTR,
                                  argument.memory.size(), argument.memory.data(), &status);
      check(status, "clCreateBuffer");
      check(clSetKernelArg(kernel, i, sizeof(cl_mem), &buffers[i]), "clSetKernelArg");
    } else if (argument.kind == KernelArgument::Kind::scalar) {
      check(clSetKernelArg(kernel, i, argument.value.size(), argument.value.data()), "clSetKernelArg");
    } else {
      check(clSetKernelArg(kernel, i, argument.local_bytes, nullptr), "clSetKernelArg");
    }
  }
  const std::array<std::size_t, 3> global{shape.global_size[0], shape.global_size[1], shape.global_size[2]};
  const std::array<std::size_t, 3> local{shape.local_size[0], shape.local_size[1], shape.local_size[2]};
  check(clEnqueueNDRangeKernel(state_->queue, kernel, 3, nullptr, global.data(), local.data(), 0, nullptr,
                               nullptr),
        "clEnqueueNDRangeKernel");
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    if (!buffers[i]) continue;
    check(clEnqueueReadBuffer(state_->queue, buffers[i], CL_TRUE, 0, arguments[i].memory.size(),
                              arguments[i].memory.data(), 0, nullptr, nullptr),
          "clEnqueueReadBuffer");
    clReleaseMemObject(buffers[i]);
  }
  clReleaseKernel(kernel);
}

}  // namespace warpgrain::profiler
