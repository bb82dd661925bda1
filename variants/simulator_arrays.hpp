#pragma once
// The arrays of a step as the simulator's memory, and launches over them in its terms: what devices that run
// kernels in it share. Needs the simulator.

#include <algorithm>
#include <utility>
#include <vector>

#include "profiler/device_buffer.hpp"
#include "profiler/launch.hpp"
#include "variants/compute_device.hpp"

namespace warpgrain {

// `Device` is ComputeDevice or an interface above it.
template <class Device>
class OverSimulatorArrays : public Device {
 public:
  void allocate(DeviceArray array, std::size_t bytes) override {
    buffers_[array] = profiler::DeviceBuffer(bytes);
  }
  void write(DeviceArray array, std::span<const std::byte> bytes) override {
    std::ranges::copy(bytes, buffers_[array].bytes().begin());
  }
  void read(DeviceArray array, std::span<std::byte> bytes) override {
    std::ranges::copy(buffers_[array].bytes().first(bytes.size()), bytes.begin());
  }
  void swap(DeviceArray first, DeviceArray second) override { std::swap(buffers_[first], buffers_[second]); }

 protected:
  static profiler::LaunchShape shape_of(const KernelLaunch& launch) {
    return {{launch.global_size, 1, 1}, {static_cast<std::uint32_t>(launch.local_size), 1, 1}};
  }
  std::vector<profiler::KernelArgument> arguments_of(const KernelLaunch& launch) {
    std::vector<profiler::KernelArgument> arguments;
    for (const LaunchArgument& argument : launch.arguments) {
      if (const auto* array = std::get_if<DeviceArray>(&argument)) {
        arguments.push_back(profiler::KernelArgument::buffer(buffers_[*array].bytes()));
      } else {
        arguments.push_back(profiler::KernelArgument::scalar(std::get<std::vector<std::byte>>(argument)));
      }
    }
    return arguments;
  }

 private:
  PerArray<profiler::DeviceBuffer> buffers_;
};

}  // namespace warpgrain
