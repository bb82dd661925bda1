#pragma once
// What a step plan needs of a device: memory under the names of arrays, and launches in order.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "variants/backend.hpp"
#include "variants/step_plan.hpp"

namespace warpgrain {

class ComputeDevice {
 public:
  virtual ~ComputeDevice() = default;
  // Compiles the plan's units. Once, before any launch. Throws InputError with the compiler's message.
  virtual void build(const std::vector<SourceUnit>& units) = 0;
  virtual void allocate(DeviceArray array, std::size_t bytes) = 0;
  virtual void write(DeviceArray array, std::span<const std::byte> bytes) = 0;
  // Waits for the launches before it.
  virtual void read(DeviceArray array, std::span<std::byte> bytes) = 0;
  virtual void swap(DeviceArray first, DeviceArray second) = 0;
  // May return before the kernel has run. Launches run one after another.
  virtual void launch(const KernelLaunch& launch) = 0;
  // Waits for all launches and collects their timings.
  virtual void finish() = 0;
  virtual std::vector<KernelTiming> timings() const = 0;
  virtual std::string name() const = 0;
  virtual std::string driver() const { return {}; }  // its version; empty where there is none
};

}  // namespace warpgrain
