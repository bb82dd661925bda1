#include "variants/cuda_driver.hpp"

#include <algorithm>
#include <cctype>
#include <fmt/format.h>
#include <fstream>
#include <limits>
#include <utility>

#include "core/error.hpp"

namespace warpgrain {
namespace {

// CUdevice_attribute, CUfunction_attribute and CUjit_option of cuda.h.
constexpr int capability_major = 75, capability_minor = 76;
constexpr int largest_block_of = 0, static_shared_of = 1, local_bytes_of = 3, registers_of = 4;
constexpr int largest_dynamic_shared_of = 8;
constexpr int jit_error_log = 5, jit_error_log_bytes = 6;

// Shared memory that a kernel gets without asking.
constexpr std::uint32_t shared_without_asking = 48u << 10;

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string name_of(CudaDeviceNumber device) {
  std::array<char, 256> name{};
  check_cuda(cuda_api().device_name(name.data(), static_cast<int>(name.size()), device), "cuda",
             "cuDeviceGetName");
  return name.data();
}

// "580.159.04" of "NVRM version: NVIDIA UNIX x86_64 Kernel Module  580.159.04  ...".
std::string kernel_module_version() {
  std::ifstream in("/proc/driver/nvidia/version");
  for (std::string word; in >> word;)
    if (std::isdigit(static_cast<unsigned char>(word.front())) && word.find('.') != std::string::npos)
      return word;
  return {};
}

}  // namespace

CudaDevice::CudaDevice(const std::string& substring) {
  const CudaApi& api = cuda_api();
  int count = 0;
  check_cuda(api.device_count(&count), "cuda", "cuDeviceGetCount");
  std::vector<std::string> names;
  bool found = false;
  for (int k = 0; k < count && !found; ++k) {
    check_cuda(api.device_get(&number_, k), "cuda", "cuDeviceGet");
    names.push_back(name_of(number_));
    found = lower_case(names.back()).find(lower_case(substring)) != std::string::npos;
  }
  if (!found) {
    const std::vector<std::string_view> valid(names.begin(), names.end());
    throw_unknown_name("--device", "CUDA device", substring, valid);
  }
  name_ = names.back();
  CudaHandle context = nullptr;
  check(api.primary_context_retain(&context, number_), "cuDevicePrimaryCtxRetain");
  check(api.context_set_current(context), "cuCtxSetCurrent");
}

CudaDevice::~CudaDevice() { cuda_api().primary_context_release(number_); }

int CudaDevice::attribute(int number) const {
  int value = 0;
  check(cuda_api().device_attribute(&value, number, number_), "cuDeviceGetAttribute");
  return value;
}

std::string CudaDevice::architecture() const {
  return fmt::format("sm_{}{}", attribute(capability_major), attribute(capability_minor));
}

std::string CudaDevice::driver() const {
  int version = 0;
  check(cuda_api().driver_version(&version), "cuDriverGetVersion");
  const std::string of_cuda = fmt::format("CUDA {}.{}", version / 1000, version % 1000 / 10);
  const std::string of_module = kernel_module_version();
  return of_module.empty() ? of_cuda : fmt::format("{}, {}", of_module, of_cuda);
}

void CudaDevice::synchronize() const { check(cuda_api().context_synchronize(), "cuCtxSynchronize"); }

CudaMemory::CudaMemory(const CudaDevice& device, std::size_t bytes) : device_(&device), bytes_(bytes) {
  if (bytes == 0) return;
  device.check(cuda_api().memory_allocate(&address_, bytes), fmt::format("cuMemAlloc of {} bytes", bytes));
  device.check(cuda_api().fill_bytes(address_, 0, bytes), "cuMemsetD8");
}

CudaMemory::~CudaMemory() {
  if (address_ != 0) cuda_api().memory_free(address_);
}

CudaMemory::CudaMemory(CudaMemory&& other) noexcept
    : device_(other.device_),
      address_(std::exchange(other.address_, 0)),
      bytes_(std::exchange(other.bytes_, 0)) {}

CudaMemory& CudaMemory::operator=(CudaMemory&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(address_, other.address_);
  std::swap(bytes_, other.bytes_);
  return *this;
}

void CudaMemory::write(std::span<const std::byte> bytes) {
  if (!bytes.empty())
    device_->check(cuda_api().copy_to_device(address_, bytes.data(), bytes.size()), "cuMemcpyHtoD");
}

void CudaMemory::read(std::span<std::byte> bytes) const {
  if (!bytes.empty())
    device_->check(cuda_api().copy_to_host(bytes.data(), address_, bytes.size()), "cuMemcpyDtoH");
}

void CudaMemory::copy_from(const CudaMemory& other) {
  if (bytes_ != 0)
    device_->check(cuda_api().copy_on_device(address_, other.address_, bytes_), "cuMemcpyDtoD");
}

int CudaFunction::attribute(int number) const {
  int value = 0;
  device_->check(cuda_api().function_attribute(&value, number, handle_), "cuFuncGetAttribute");
  return value;
}

int CudaFunction::registers() const { return attribute(registers_of); }
int CudaFunction::static_shared_bytes() const { return attribute(static_shared_of); }
int CudaFunction::local_bytes() const { return attribute(local_bytes_of); }
int CudaFunction::largest_block() const { return attribute(largest_block_of); }

void CudaFunction::launch(const std::array<std::uint64_t, 3>& groups,
                          const std::array<std::uint32_t, 3>& group_size, std::uint32_t shared_bytes,
                          std::span<void*> parameters) const {
  const std::uint64_t threads = std::uint64_t{group_size[0]} * group_size[1] * group_size[2];
  if (const int most = largest_block(); threads > static_cast<std::uint64_t>(most))
    throw_input_error(device_->name(), fmt::format("{} work-items in a work-group of '{}'", threads, name_),
                      fmt::format("at most {}", most));
  for (const std::uint64_t n : groups)
    if (n > std::numeric_limits<unsigned>::max())
      throw_input_error(device_->name(), fmt::format("{} work-groups of '{}'", n, name_), "less than 2^32");
  if (shared_bytes + static_cast<std::uint32_t>(static_shared_bytes()) > shared_without_asking)
    device_->check(
        cuda_api().function_set_attribute(handle_, largest_dynamic_shared_of, static_cast<int>(shared_bytes)),
        fmt::format("cuFuncSetAttribute for {} bytes of local memory of '{}'", shared_bytes, name_));
  device_->check(
      cuda_api().launch(handle_, static_cast<unsigned>(groups[0]), static_cast<unsigned>(groups[1]),
                        static_cast<unsigned>(groups[2]), group_size[0], group_size[1], group_size[2],
                        shared_bytes, nullptr, parameters.data(), nullptr),
      fmt::format("cuLaunchKernel of '{}'", name_));
}

CudaModule::CudaModule(const CudaDevice& device, const std::string& image, std::string_view where)
    : device_(&device), where_(where) {
  std::string log(1 << 14, '\0');
  std::array<int, 2> options{jit_error_log, jit_error_log_bytes};
  std::array<void*, 2> values{log.data(), reinterpret_cast<void*>(log.size())};
  const CudaResult result =
      cuda_api().module_load(&handle_, image.c_str(), options.size(), options.data(), values.data());
  if (result == 0) return;
  handle_ = nullptr;
  log.resize(log.find('\0') == std::string::npos ? log.size() : log.find('\0'));
  while (log.ends_with('\n')) log.pop_back();
  try {
    check_cuda(result, fmt::format("{} on {}", where, device.name()), "cuModuleLoadDataEx");
  } catch (const InputError& error) {
    throw InputError(log.empty() ? std::string(error.what()) : fmt::format("{}\n{}", error.what(), log));
  }
}

CudaModule::~CudaModule() {
  if (handle_ != nullptr) cuda_api().module_unload(handle_);
}

CudaModule::CudaModule(CudaModule&& other) noexcept
    : device_(other.device_),
      where_(std::move(other.where_)),
      handle_(std::exchange(other.handle_, nullptr)) {}

CudaFunction CudaModule::function(const std::string& name) const {
  CudaHandle handle = nullptr;
  device_->check(cuda_api().module_function(&handle, handle_, name.c_str()),
                 fmt::format("cuModuleGetFunction of '{}' in {}", name, where_));
  return {*device_, handle, name};
}

CudaProfilerRange::CudaProfilerRange() { check_cuda(cuda_api().profiler_start(), "cuda", "cuProfilerStart"); }

CudaProfilerRange::~CudaProfilerRange() {
  cuda_api().context_synchronize();
  cuda_api().profiler_stop();
}

CudaEvent::CudaEvent(const CudaDevice& device) : device_(&device) {
  device.check(cuda_api().event_create(&handle_, 0), "cuEventCreate");
}

CudaEvent::~CudaEvent() {
  if (handle_ != nullptr) cuda_api().event_destroy(handle_);
}

CudaEvent::CudaEvent(CudaEvent&& other) noexcept
    : device_(other.device_), handle_(std::exchange(other.handle_, nullptr)) {}

void CudaEvent::record() { device_->check(cuda_api().event_record(handle_, nullptr), "cuEventRecord"); }

double CudaEvent::seconds_since(const CudaEvent& begin) const {
  device_->check(cuda_api().event_synchronize(handle_), "cuEventSynchronize");
  float milliseconds = 0;
  device_->check(cuda_api().event_elapsed(&milliseconds, begin.handle_, handle_), "cuEventElapsedTime");
  return 1e-3 * static_cast<double>(milliseconds);
}

}  // namespace warpgrain
