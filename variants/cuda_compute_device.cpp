#include "variants/cuda_compute_device.hpp"

#include "core/error.hpp"

#ifdef WARPGRAIN_HAS_SIMULATOR

#include <map>
#include <optional>
#include <utility>

#include "profiler/opencl_frontend.hpp"  // CompiledPtx
#include "variants/cuda_driver.hpp"
#include "variants/cuda_helpers.hpp"
#include "variants/cuda_program.hpp"

namespace warpgrain {
namespace {

using KernelTimes = BackendOptions::KernelTimes;

// More than the host takes to queue a step: a hundred launches of some 6 us each.
constexpr double step_delay_seconds = 2e-3;

class CudaComputeDevice : public ComputeDevice {
 public:
  explicit CudaComputeDevice(const BackendOptions& options)
      : device_(options.device), times_(options.kernel_times), compiler_(options.compiler) {
    if (times_ == KernelTimes::undisturbed) delay_.emplace(device_);
  }

  void build(const std::vector<SourceUnit>& units) override {
    for (const SourceUnit& unit : units) {
      const std::string ptx = compile_unit(unit, compiler_).ptx;
      CudaModule module =
          load_program(device_, assemble_for_cuda(device_, CudaAssembler::driver, ptx, where), where);
      units_.push_back({std::move(module), {}});
    }
  }

  void allocate(DeviceArray array, std::size_t bytes) override {
    buffers_[array] = CudaMemory(device_, bytes);
  }
  void write(DeviceArray array, std::span<const std::byte> bytes) override { buffers_[array].write(bytes); }
  void read(DeviceArray array, std::span<std::byte> bytes) override { buffers_[array].read(bytes); }
  void swap(DeviceArray first, DeviceArray second) override { std::swap(buffers_[first], buffers_[second]); }

  void launch(const KernelLaunch& launch) override {
    Kernel& kernel = kernel_of(launch);
    std::vector<CudaAddress> addresses;
    std::vector<void*> parameters;
    addresses.reserve(launch.arguments.size());  // parameters point into it
    for (const LaunchArgument& argument : launch.arguments) {
      if (const auto* array = std::get_if<DeviceArray>(&argument)) {
        parameters.push_back(&addresses.emplace_back(buffers_[*array].address()));
      } else {
        // The driver copies the value, and takes it as one that may be written to.
        parameters.push_back(const_cast<std::byte*>(std::get<std::vector<std::byte>>(argument).data()));
      }
    }
    const auto size = static_cast<std::uint32_t>(launch.local_size);
    const auto run = [&] {
      kernel.function.launch({launch.global_size / size, 1, 1}, {size, 1, 1}, 0, parameters);
    };
    if (times_ == KernelTimes::none) return run();
    if (delay_ && running_.empty()) delay_->launch(step_delay_seconds);
    Running running{kernel.timing, take_event(), take_event()};
    running.begin.record();
    run();
    running.end.record();
    running_.push_back(std::move(running));
  }

  void finish() override {
    device_.synchronize();
    for (Running& running : running_) {
      timings_[running.timing].calls += 1;
      timings_[running.timing].seconds += running.end.seconds_since(running.begin);
      free_events_.push_back(std::move(running.begin));
      free_events_.push_back(std::move(running.end));
    }
    running_.clear();
  }

  std::vector<KernelTiming> timings() const override { return timings_; }
  std::string name() const override { return device_.name(); }
  std::string driver() const override { return device_.driver(); }

 private:
  static constexpr const char* where = "kernels";

  struct Kernel {
    CudaFunction function;
    std::size_t timing = 0;  // index into timings_
  };
  struct Unit {
    CudaModule module;
    std::map<std::string, Kernel> kernels;
  };
  struct Running {
    std::size_t timing;
    CudaEvent begin, end;
  };

  Kernel& kernel_of(const KernelLaunch& launch) {
    Unit& unit = units_[launch.unit];
    const auto it = unit.kernels.find(launch.kernel);
    if (it != unit.kernels.end()) return it->second;
    const Kernel kernel{unit.module.function(launch.kernel), timings_.size()};
    timings_.push_back({launch.kernel, 0, 0});
    return unit.kernels.emplace(launch.kernel, kernel).first->second;
  }

  CudaEvent take_event() {
    if (free_events_.empty()) return CudaEvent(device_);
    CudaEvent event = std::move(free_events_.back());
    free_events_.pop_back();
    return event;
  }

  CudaDevice device_;
  KernelTimes times_;
  KernelCompiler compiler_;
  std::optional<CudaDelay> delay_;
  std::vector<Unit> units_;
  PerArray<CudaMemory> buffers_;
  std::vector<Running> running_;  // since the last finish()
  std::vector<CudaEvent> free_events_;
  std::vector<KernelTiming> timings_;
};

}  // namespace

std::string cuda_device_lacks() { return cuda_lacks(); }

std::unique_ptr<ComputeDevice> open_cuda_device(const BackendOptions& options) {
  return std::make_unique<CudaComputeDevice>(options);
}

}  // namespace warpgrain

#else

namespace warpgrain {

std::string cuda_device_lacks() {
  return "built without the simulator (WARPGRAIN_SIMULATOR=OFF), whose compiler it takes";
}

std::unique_ptr<ComputeDevice> open_cuda_device(const BackendOptions&) {
  throw_input_error("cuda", cuda_device_lacks());
}

}  // namespace warpgrain

#endif
