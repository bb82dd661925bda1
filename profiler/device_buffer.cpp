#include "profiler/device_buffer.hpp"

#include <cstring>
#include <new>

namespace warpgrain::profiler {

DeviceBuffer::DeviceBuffer(std::size_t bytes) : size_(bytes) {
  if (bytes == 0) return;
  data_.reset(static_cast<std::byte*>(::operator new[](bytes, std::align_val_t{alignment})));
  std::memset(data_.get(), 0, bytes);
}

void DeviceBuffer::Free::operator()(std::byte* data) const {
  ::operator delete[](data, std::align_val_t{alignment});
}

}  // namespace warpgrain::profiler
