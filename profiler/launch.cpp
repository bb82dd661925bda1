#include "profiler/launch.hpp"

namespace warpgrain::profiler {

KernelArgument KernelArgument::buffer(std::span<std::byte> memory) {
  KernelArgument argument;
  argument.kind = Kind::buffer;
  argument.memory = memory;
  return argument;
}

KernelArgument KernelArgument::scalar(std::span<const std::byte> value) {
  KernelArgument argument;
  argument.kind = Kind::scalar;
  argument.value.assign(value.begin(), value.end());
  return argument;
}

KernelArgument KernelArgument::local(std::uint32_t bytes) {
  KernelArgument argument;
  argument.kind = Kind::local;
  argument.local_bytes = bytes;
  return argument;
}

}  // namespace warpgrain::profiler
