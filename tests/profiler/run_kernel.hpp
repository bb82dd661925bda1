#pragma once
// Runs whole launches in tests: every work-group of an executable, one after another.

#include <array>
#include <cstddef>
#include <cstring>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/opencl_frontend.hpp"

namespace warpgrain::profiler {

template <class T>
KernelArgument buffer_of(std::vector<T>& values) {
  return KernelArgument::buffer(std::as_writable_bytes(std::span(values)));
}

template <class T>
KernelArgument scalar_of(const T& value) {
  return KernelArgument::scalar(std::as_bytes(std::span(&value, 1)));
}

inline LaunchShape line_of(std::uint64_t global, std::uint32_t local) {
  return {{global, 1, 1}, {local, 1, 1}};
}

inline std::unique_ptr<Executable> compile_kernel(std::string_view source, std::string_view kernel,
                                                  TraceMode mode = TraceMode::blocks_and_addresses,
                                                  std::string_view options = {}) {
  return Executable::compile(compile_opencl(source, "kernel.cl", options).ptx, kernel, mode, "kernel.cl");
}

inline void run_launch(const Executable& executable, const LaunchShape& shape,
                       const std::vector<KernelArgument>& arguments) {
  const auto runner = executable.runner(shape, arguments);
  const auto groups = shape.group_count();
  for (std::uint64_t z = 0; z < groups[2]; ++z)
    for (std::uint64_t y = 0; y < groups[1]; ++y)
      for (std::uint64_t x = 0; x < groups[0]; ++x) runner->run({x, y, z});
}

// What a call refuses its input with; empty when it does not.
template <class Call>
std::string refusal(Call&& call) {
  try {
    call();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

}  // namespace warpgrain::profiler
