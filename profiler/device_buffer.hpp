#pragma once
// Memory for a kernel's buffer, aligned as a GPU aligns it, so that sectors come out as there.

#include <cstddef>
#include <memory>
#include <span>

namespace warpgrain::profiler {

class DeviceBuffer {
 public:
  static constexpr std::size_t alignment = 256;

  DeviceBuffer() = default;                  // of no bytes
  explicit DeviceBuffer(std::size_t bytes);  // zeros
  std::span<std::byte> bytes() const { return {data_.get(), size_}; }

 private:
  struct Free {
    void operator()(std::byte* data) const;
  };
  std::unique_ptr<std::byte[], Free> data_;
  std::size_t size_ = 0;
};

}  // namespace warpgrain::profiler
