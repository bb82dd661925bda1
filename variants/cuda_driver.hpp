#pragma once
// A CUDA device, its memory, modules and events, as objects that clean up behind themselves. Everything runs
// on the default stream of the device's primary context, one call after another. Errors are InputErrors that
// name the device, the call and CUDA's own name of the error.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "variants/cuda_api.hpp"

namespace warpgrain {

class CudaDevice {
 public:
  // The first device whose name contains `substring`, whatever the case; empty: the first. Throws InputError
  // that lists the names there are.
  explicit CudaDevice(const std::string& substring);
  ~CudaDevice();
  CudaDevice(const CudaDevice&) = delete;
  CudaDevice& operator=(const CudaDevice&) = delete;

  const std::string& name() const { return name_; }
  // "sm_90"
  std::string architecture() const;
  // "580.159.04, CUDA 13.0"; the first where the system tells it.
  std::string driver() const;
  int attribute(int number) const;
  // Waits for everything that was launched; where a kernel has failed, this is where it shows.
  void synchronize() const;
  void check(CudaResult result, std::string_view call) const { check_cuda(result, name_, call); }

 private:
  std::string name_;
  CudaDeviceNumber number_ = 0;
};

class CudaMemory {
 public:
  CudaMemory() = default;                                   // no bytes, a null address
  CudaMemory(const CudaDevice& device, std::size_t bytes);  // 256-byte aligned, zeros
  ~CudaMemory();
  CudaMemory(CudaMemory&& other) noexcept;
  CudaMemory& operator=(CudaMemory&& other) noexcept;

  CudaAddress address() const { return address_; }
  std::size_t size() const { return bytes_; }
  void write(std::span<const std::byte> bytes);  // [at most size]
  void read(std::span<std::byte> bytes) const;   // [at most size]; waits for what was launched
  void copy_from(const CudaMemory& other);       // of the same size

 private:
  const CudaDevice* device_ = nullptr;
  CudaAddress address_ = 0;
  std::size_t bytes_ = 0;
};

class CudaFunction {
 public:
  int registers() const;
  int static_shared_bytes() const;
  int local_bytes() const;  // of a thread: spills, and arrays that are indexed
  int largest_block() const;
  // `parameters`: a pointer to each parameter's value. Returns before the kernel has run.
  void launch(const std::array<std::uint64_t, 3>& groups, const std::array<std::uint32_t, 3>& group_size,
              std::uint32_t shared_bytes, std::span<void*> parameters) const;

 private:
  friend class CudaModule;
  CudaFunction(const CudaDevice& device, CudaHandle handle, std::string name)
      : device_(&device), handle_(handle), name_(std::move(name)) {}
  int attribute(int number) const;

  const CudaDevice* device_;
  CudaHandle handle_;
  std::string name_;
};

class CudaModule {
 public:
  // `image` is PTX, which the driver assembles, or a cubin. `where` names it in messages. Throws InputError
  // with the driver's log.
  CudaModule(const CudaDevice& device, const std::string& image, std::string_view where);
  ~CudaModule();
  CudaModule(CudaModule&& other) noexcept;
  CudaModule& operator=(CudaModule&&) = delete;

  CudaFunction function(const std::string& name) const;

 private:
  const CudaDevice* device_;
  std::string where_;
  CudaHandle handle_ = nullptr;
};

// What a profiler is to look at, as `ncu --profile-from-start off` waits for it. Waits for what was launched
// before it ends.
class CudaProfilerRange {
 public:
  CudaProfilerRange();
  ~CudaProfilerRange();
  CudaProfilerRange(const CudaProfilerRange&) = delete;
  CudaProfilerRange& operator=(const CudaProfilerRange&) = delete;
};

// A mark in the stream.
class CudaEvent {
 public:
  explicit CudaEvent(const CudaDevice& device);
  ~CudaEvent();
  CudaEvent(CudaEvent&& other) noexcept;
  CudaEvent& operator=(CudaEvent&&) = delete;

  void record();
  // Waits for this event.
  double seconds_since(const CudaEvent& begin) const;

 private:
  const CudaDevice* device_;
  CudaHandle handle_ = nullptr;
};

}  // namespace warpgrain
