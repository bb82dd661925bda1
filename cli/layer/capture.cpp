#include "cli/layer/capture.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain::layer {
namespace {

// The work-items that a driver is taken to put into a work-group where the application leaves that open.
constexpr std::uint64_t work_group_size_by_default = 256;

[[noreturn]] void fail(const char* function, cl_int status) {
  throw InputError(fmt::format("its buffers cannot be read: {} gives {}", function, status));
}

void require(cl_int status, const char* function) {
  if (status != CL_SUCCESS) fail(function, status);
}

// A memory object that lives as long as this.
class Held {
 public:
  Held(const cl_icd_dispatch& cl, cl_mem memory) : cl_(cl), memory_(memory) {}
  ~Held() { cl_.clReleaseMemObject(memory_); }
  Held(const Held&) = delete;
  Held& operator=(const Held&) = delete;

 private:
  const cl_icd_dispatch& cl_;
  cl_mem memory_;
};

template <typename T>
T memory_info(const cl_icd_dispatch& cl, cl_mem memory, cl_mem_info what) {
  T value{};
  require(cl.clGetMemObjectInfo(memory, what, sizeof value, &value, nullptr), "clGetMemObjectInfo");
  return value;
}

// The largest divisor of `size` up to `limit`.
std::uint32_t largest_divisor(std::uint64_t size, std::uint64_t limit) {
  std::uint64_t divisor = std::min(size, limit);
  while (size % divisor != 0) --divisor;
  return static_cast<std::uint32_t>(divisor);
}

// The memory below sub-buffers, and where in it the object lies.
struct Place {
  cl_mem memory = nullptr;
  std::size_t begin = 0, end = 0;
  bool overlaps(const Place& other) const {
    return memory == other.memory && begin < other.end && other.begin < end;
  }
};

Place place_of(const cl_icd_dispatch& cl, cl_mem memory) {
  const auto below = memory_info<cl_mem>(cl, memory, CL_MEM_ASSOCIATED_MEMOBJECT);
  const auto begin = below ? memory_info<std::size_t>(cl, memory, CL_MEM_OFFSET) : 0;
  return {below ? below : memory, begin, begin + memory_info<std::size_t>(cl, memory, CL_MEM_SIZE)};
}

std::string overlap_remark(const cl_icd_dispatch& cl, const Kernel& kernel) {
  std::vector<std::pair<std::size_t, Place>> places;
  std::string text;
  for (std::size_t i = 0; i < kernel.arguments.size(); ++i) {
    if (kernel.arguments[i].kind != Argument::Kind::memory) continue;
    const Place place = place_of(cl, kernel.arguments[i].memory);
    for (const auto& [other, of_other] : places)
      if (place.overlaps(of_other))
        text += fmt::format("{}arguments {} and {} share memory, in the simulator they do not",
                            text.empty() ? "" : "; ", other, i);
    places.emplace_back(i, place);
  }
  return text;
}

}  // namespace

std::uint64_t Enqueued::work_items() const {
  std::uint64_t count = 1;
  for (cl_uint d = 0; d < dimensions; ++d) count *= global_size[d];
  return count;
}

std::string Capturing::unprofiled(cl_uint index, const Argument& argument) const {
  switch (argument.kind) {
    case Argument::Kind::unset:
      return fmt::format("argument {} has no value that was seen", index);
    case Argument::Kind::shared_virtual_memory:
      return "shared virtual memory";
    case Argument::Kind::sampler:
      return "a sampler";
    case Argument::Kind::memory: {
      if (handles_.kind_of(argument.memory) != Argument::Kind::memory)
        return fmt::format("argument {} is a memory object that was released", index);
      const auto type = memory_info<cl_mem_object_type>(cl_, argument.memory, CL_MEM_TYPE);
      return type == CL_MEM_OBJECT_BUFFER ? "" : type == CL_MEM_OBJECT_PIPE ? "a pipe" : "an image";
    }
    case Argument::Kind::unseen:
      return fmt::format("argument {} is a memory object whose making was not seen", index);
    case Argument::Kind::value:
    case Argument::Kind::local:
    case Argument::Kind::null_pointer:
      break;
  }
  return "";
}

std::string Capturing::unprofiled(const Kernel& kernel, const Enqueued& launch) const {
  if (!kernel.program->unknown.empty()) return kernel.program->unknown;
  if (kernel.uses_shared_virtual_memory) return "shared virtual memory";
  if (launch.dimensions < 1 || launch.dimensions > 3 || launch.global_size == nullptr ||
      launch.work_items() == 0)
    return "no work-items";
  for (cl_uint d = 0; d < launch.dimensions; ++d)
    if (launch.offset != nullptr && launch.offset[d] != 0) return "a global work offset";
  cl_uint n_arguments = 0;
  require(cl_.clGetKernelInfo(launch.kernel, CL_KERNEL_NUM_ARGS, sizeof n_arguments, &n_arguments, nullptr),
          "clGetKernelInfo");
  for (cl_uint i = 0; i < n_arguments; ++i) {
    const Argument argument = i < kernel.arguments.size() ? kernel.arguments[i] : Argument{};
    if (std::string why = unprofiled(i, argument); !why.empty()) return why;
  }
  return "";
}

profiler::LaunchShape Capturing::shape_of(const Enqueued& launch) const {
  profiler::LaunchShape shape;
  for (cl_uint d = 0; d < launch.dimensions; ++d) shape.global_size[d] = launch.global_size[d];
  if (launch.local_size != nullptr) {
    for (cl_uint d = 0; d < launch.dimensions; ++d)
      shape.local_size[d] = static_cast<std::uint32_t>(launch.local_size[d]);
    return shape;
  }
  std::array<std::size_t, 3> required{};
  cl_device_id device = nullptr;
  require(cl_.clGetCommandQueueInfo(launch.queue, CL_QUEUE_DEVICE, sizeof device, &device, nullptr),
          "clGetCommandQueueInfo");
  if (cl_.clGetKernelWorkGroupInfo(launch.kernel, device, CL_KERNEL_COMPILE_WORK_GROUP_SIZE, sizeof required,
                                   required.data(), nullptr) == CL_SUCCESS &&
      required[0] != 0) {
    for (std::size_t d = 0; d < 3; ++d) shape.local_size[d] = static_cast<std::uint32_t>(required[d]);
    return shape;
  }
  std::uint64_t left = work_group_size_by_default;
  for (std::size_t d = 0; d < 3; ++d) {
    shape.local_size[d] = largest_divisor(shape.global_size[d], left);
    left /= shape.local_size[d];
  }
  return shape;
}

std::vector<std::byte> Capturing::read(cl_mem buffer, const Enqueued& launch) const {
  std::vector<std::byte> bytes(memory_info<std::size_t>(cl_, buffer, CL_MEM_SIZE));
  const auto read_from = [&](cl_mem memory, cl_uint n_wait, const cl_event* wait_list) {
    return cl_.clEnqueueReadBuffer(launch.queue, memory, CL_TRUE, 0, bytes.size(), bytes.data(), n_wait,
                                   wait_list, nullptr);
  };
  const cl_int status = read_from(buffer, launch.n_wait, launch.wait_list);
  if (status == CL_SUCCESS) return bytes;
  if (status != CL_INVALID_OPERATION) fail("clEnqueueReadBuffer", status);
  // A buffer that the host may not read: a copy of it may be.
  cl_context context = memory_info<cl_context>(cl_, buffer, CL_MEM_CONTEXT);
  cl_int error = CL_SUCCESS;
  cl_mem copy = cl_.clCreateBuffer(context, CL_MEM_READ_WRITE, bytes.size(), nullptr, &error);
  require(error, "clCreateBuffer");
  const Held held(cl_, copy);
  cl_event copied = nullptr;
  require(cl_.clEnqueueCopyBuffer(launch.queue, buffer, copy, 0, 0, bytes.size(), launch.n_wait,
                                  launch.wait_list, &copied),
          "clEnqueueCopyBuffer");
  const cl_int status_of_copy = read_from(copy, 1, &copied);
  cl_.clReleaseEvent(copied);
  require(status_of_copy, "clEnqueueReadBuffer");
  return bytes;
}

CapturedArgument Capturing::capture(const Argument& argument, const Enqueued& launch) const {
  CapturedArgument captured;
  if (argument.kind == Argument::Kind::memory) {
    require(cl_.clRetainMemObject(argument.memory), "clRetainMemObject");
    const Held held(cl_, argument.memory);
    captured.is_buffer = true;
    captured.bytes = read(argument.memory, launch);
    captured.read_only =
        (memory_info<cl_mem_flags>(cl_, argument.memory, CL_MEM_FLAGS) & CL_MEM_READ_ONLY) != 0;
    return captured;
  }
  if (argument.kind == Argument::Kind::null_pointer)
    captured.argument.is_null = true;
  else if (argument.kind == Argument::Kind::local)
    captured.argument.size = argument.size;
  else
    captured.argument = profiler::scalar_argument(argument.bytes);
  return captured;
}

std::uint64_t Capturing::buffer_bytes(const Kernel& kernel) const {
  std::uint64_t bytes = 0;
  for (const Argument& argument : kernel.arguments)
    if (argument.kind == Argument::Kind::memory &&
        handles_.kind_of(argument.memory) == Argument::Kind::memory)
      bytes += memory_info<std::size_t>(cl_, argument.memory, CL_MEM_SIZE);
  return bytes;
}

Capture Capturing::capture(const Kernel& kernel, const Enqueued& launch) const {
  Capture captured;
  captured.unprofiled = unprofiled(kernel, launch);
  if (!captured.unprofiled.empty()) return captured;
  captured.remark = overlap_remark(cl_, kernel);
  captured.shape = shape_of(launch);
  for (const Argument& argument : kernel.arguments) captured.arguments.push_back(capture(argument, launch));
  return captured;
}

}  // namespace warpgrain::layer
