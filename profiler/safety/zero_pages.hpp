#pragma once
// An array of zeros whose pages exist from the first write on.

#include <cstddef>
#include <new>
#include <sys/mman.h>
#include <utility>

namespace warpgrain::profiler {

template <class T>
class ZeroPages {
 public:
  ZeroPages() = default;
  // Throws std::bad_alloc when the address space is not to be had.
  explicit ZeroPages(std::size_t size) : bytes_(size * sizeof(T)) {
    if (bytes_ == 0) return;
    void* memory =
        mmap(nullptr, bytes_, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
    if (memory == MAP_FAILED) throw std::bad_alloc();
    // Fewer, larger pages where the system has them: most of an array is touched, or none of it.
    madvise(memory, bytes_, MADV_HUGEPAGE);
    data_ = static_cast<T*>(memory);
  }
  ~ZeroPages() {
    if (data_) munmap(data_, bytes_);
  }
  ZeroPages(ZeroPages&& other) noexcept { swap(other); }
  ZeroPages& operator=(ZeroPages&& other) noexcept {
    swap(other);
    return *this;
  }

  T* data() const { return data_; }
  T& operator[](std::size_t index) const { return data_[index]; }
  explicit operator bool() const { return data_ != nullptr; }

 private:
  void swap(ZeroPages& other) {
    std::swap(data_, other.data_);
    std::swap(bytes_, other.bytes_);
  }

  T* data_ = nullptr;
  std::size_t bytes_ = 0;
};

}  // namespace warpgrain::profiler
