#pragma once
// A kernel launch: its index space and its arguments.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace warpgrain::profiler {

struct LaunchShape {
  std::array<std::uint64_t, 3> global_size{1, 1, 1};  // work-items
  // The last work-groups of a dimension are smaller where it does not divide global_size (OpenCL 2.0).
  std::array<std::uint32_t, 3> local_size{1, 1, 1};
  std::array<std::uint64_t, 3> group_count() const {
    std::array<std::uint64_t, 3> groups{};
    for (std::size_t d = 0; d < 3; ++d) groups[d] = (global_size[d] + local_size[d] - 1) / local_size[d];
    return groups;
  }
  // The local size of one work-group.
  std::array<std::uint32_t, 3> local_size_of(const std::array<std::uint64_t, 3>& group) const {
    std::array<std::uint32_t, 3> size{};
    for (std::size_t d = 0; d < 3; ++d)
      size[d] = static_cast<std::uint32_t>(
          std::min<std::uint64_t>(local_size[d], global_size[d] - group[d] * local_size[d]));
    return size;
  }
  bool is_uniform() const {
    return global_size[0] % local_size[0] == 0 && global_size[1] % local_size[1] == 0 &&
           global_size[2] % local_size[2] == 0;
  }
  // Of the largest.
  std::uint32_t work_group_size() const { return local_size[0] * local_size[1] * local_size[2]; }
};

struct KernelArgument {
  enum class Kind : std::uint8_t {
    buffer,  // `memory` is the buffer, 256-byte aligned; the kernel gets its address (null when empty)
    scalar,  // `value` holds the bytes, a struct by value included
    local    // `local_bytes` of shared memory for each work-group; the kernel gets their place
  };
  Kind kind = Kind::scalar;
  std::span<std::byte> memory;
  std::vector<std::byte> value;
  std::uint32_t local_bytes = 0;

  // What checked code is told of a buffer.
  std::string name;                // in diagnostics; empty: the parameter's
  std::uint32_t vector_bytes = 0;  // of an element that is a vector; 0: it is none, or not known
  bool read_only = false, write_only = false;
  bool uninitialized = false;  // no byte has a value yet

  static KernelArgument buffer(std::span<std::byte> memory);
  static KernelArgument scalar(std::span<const std::byte> value);
  static KernelArgument local(std::uint32_t bytes);
};

// A parameter as the kernel's PTX signature declares it.
struct KernelParameter {
  std::string name;
  std::uint32_t bytes = 0;
  std::uint32_t alignment = 1;
  enum class Pointer : std::uint8_t { none, global, shared, constant } pointer = Pointer::none;
};

}  // namespace warpgrain::profiler
