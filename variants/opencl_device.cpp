#include "variants/opencl_device.hpp"

#define CL_HPP_ENABLE_EXCEPTIONS
#define CL_HPP_TARGET_OPENCL_VERSION 120
#define CL_HPP_MINIMUM_OPENCL_VERSION 120
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wpedantic"
#include <CL/opencl.hpp>
#pragma GCC diagnostic pop
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fmt/format.h>
#include <fstream>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "core/error.hpp"
#include "variants/opencl_ptx.hpp"

namespace warpgrain {
namespace {

struct FoundDevice {
  cl::Device device;
  std::string platform, name;
};

std::vector<FoundDevice> find_devices() {
  std::vector<FoundDevice> found;
  std::vector<cl::Platform> platforms;
  try {
    cl::Platform::get(&platforms);
  } catch (const cl::Error&) {
    return found;  // the loader reports "no platform" as an error
  }
  for (const cl::Platform& platform : platforms) {
    std::vector<cl::Device> devices;
    try {
      platform.getDevices(CL_DEVICE_TYPE_ALL, &devices);
    } catch (const cl::Error&) {
      continue;  // and "no device" likewise
    }
    for (const cl::Device& device : devices) {
      found.push_back({device, platform.getInfo<CL_PLATFORM_NAME>(), device.getInfo<CL_DEVICE_NAME>()});
    }
  }
  return found;
}

std::string lower_case(std::string text) {
  std::ranges::transform(text, text.begin(),
                         [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

FoundDevice choose_device(const std::string& substring) {
  const std::vector<FoundDevice> found = find_devices();
  if (found.empty())
    throw_input_error("opencl", "no device found", "an OpenCL driver, such as pocl-opencl-icd");
  const auto matches = [](const FoundDevice& device, const std::string& text) {
    return lower_case(device.platform + ' ' + device.name).find(lower_case(text)) != std::string::npos;
  };
  const std::string wanted = substring.empty() ? "portable computing language" : substring;
  const auto it =
      std::ranges::find_if(found, [&](const FoundDevice& device) { return matches(device, wanted); });
  if (it != found.end()) return *it;
  if (substring.empty()) return found.front();
  std::vector<std::string_view> names;
  for (const FoundDevice& device : found) names.push_back(device.name);
  throw_unknown_name("--device", "device", substring, names);
}

// The context of a device and the programs built in it, for all simulations of the process: even a program
// that the driver finds on disk takes as long to build as some hundred steps of a small scene.
class SharedContext {
 public:
  explicit SharedContext(const cl::Device& device) : device_(device), context_(device) {}

  const cl::Context& context() const { return context_; }
  // Throws cl::BuildError.
  cl::Program program(const SourceUnit& unit) {
    const std::lock_guard lock(mutex_);
    const auto found = programs_.find({unit.text, unit.build_options});
    if (found != programs_.end()) return found->second;
    cl::Program program(context_, unit.text);
    program.build(device_, unit.build_options.c_str());
    if (programs_.size() == most_programs) programs_.clear();
    return programs_[{unit.text, unit.build_options}] = program;
  }

  // Never destroyed: drivers may be gone before static objects are.
  static SharedContext& of(const cl::Device& device) {
    static std::mutex mutex;
    static auto* const contexts = new std::map<cl_device_id, std::unique_ptr<SharedContext>>;
    const std::lock_guard lock(mutex);
    std::unique_ptr<SharedContext>& context = (*contexts)[device()];
    if (!context) context = std::make_unique<SharedContext>(device);
    return *context;
  }

 private:
  static constexpr std::size_t most_programs = 64;
  cl::Device device_;
  cl::Context context_;
  std::mutex mutex_;
  std::map<std::pair<std::string, std::string>, cl::Program> programs_;  // by text and options
};

class OpenclDevice : public ComputeDevice {
 public:
  OpenclDevice(const FoundDevice& found, std::filesystem::path ptx_folder)
      : name_(found.name),
        ptx_folder_(std::move(ptx_folder)),
        device_(found.device),
        shared_(SharedContext::of(found.device)),
        context_(shared_.context()),
        queue_(context_, found.device, CL_QUEUE_PROFILING_ENABLE) {}

  void build(const std::vector<SourceUnit>& units) override {
    for (const SourceUnit& unit : units) {
      try {
        units_.push_back({shared_.program(unit), {}});
      } catch (const cl::BuildError& error) {
        std::string log = error.getBuildLog().empty() ? std::string() : error.getBuildLog().front().second;
        while (!log.empty() && (log.back() == '\n' || log.back() == '\0')) log.pop_back();
        throw_input_error("kernels", fmt::format("do not compile for {}\n{}", name_, log));
      }
      if (!ptx_folder_.empty()) guarded([&] { keep_ptx(units_.back().program); });
    }
  }

  void allocate(DeviceArray array, std::size_t bytes) override {
    guarded([&] { buffers_[array] = cl::Buffer(context_, CL_MEM_READ_WRITE, bytes); });
  }
  void write(DeviceArray array, std::span<const std::byte> bytes) override {
    guarded([&] { queue_.enqueueWriteBuffer(buffers_[array], CL_TRUE, 0, bytes.size(), bytes.data()); });
  }
  void read(DeviceArray array, std::span<std::byte> bytes) override {
    guarded([&] { queue_.enqueueReadBuffer(buffers_[array], CL_TRUE, 0, bytes.size(), bytes.data()); });
  }
  void swap(DeviceArray first, DeviceArray second) override { std::swap(buffers_[first], buffers_[second]); }

  void launch(const KernelLaunch& launch) override {
    guarded([&] {
      BuiltKernel& built = kernel(launch);
      for (cl_uint k = 0; k < launch.arguments.size(); ++k) {
        if (const auto* array = std::get_if<DeviceArray>(&launch.arguments[k])) {
          built.kernel.setArg(k, buffers_[*array]);
        } else {
          const auto& bytes = std::get<std::vector<std::byte>>(launch.arguments[k]);
          built.kernel.setArg(k, bytes.size(), bytes.data());
        }
      }
      cl::Event event;
      queue_.enqueueNDRangeKernel(built.kernel, cl::NullRange, cl::NDRange(launch.global_size),
                                  cl::NDRange(launch.local_size), nullptr, &event);
      running_.push_back({built.timing, std::move(event)});
    });
  }

  void finish() override {
    guarded([&] {
      queue_.finish();
      for (const auto& [timing, event] : running_) {
        const cl_ulong begin = event.getProfilingInfo<CL_PROFILING_COMMAND_START>();
        const cl_ulong end = event.getProfilingInfo<CL_PROFILING_COMMAND_END>();
        timings_[timing].calls += 1;
        timings_[timing].seconds += 1e-9 * static_cast<double>(end - begin);
      }
      running_.clear();
    });
  }

  std::vector<KernelTiming> timings() const override { return timings_; }
  std::string name() const override { return name_; }
  std::string driver() const override { return device_.getInfo<CL_DRIVER_VERSION>(); }

 private:
  struct BuiltKernel {
    cl::Kernel kernel;
    std::size_t timing = 0;  // index into timings_
  };
  struct Unit {
    cl::Program program;
    std::map<std::string, BuiltKernel> kernels;
  };

  // OpenCL's own errors (no memory, a lost device) become the one kind of error that users see.
  template <class Call>
  void guarded(Call call) const {
    try {
      call();
    } catch (const cl::Error& error) {
      throw_input_error(name_, fmt::format("{} failed with OpenCL error {}", error.what(), error.err()));
    }
  }

  void keep_ptx(const cl::Program& program) const {
    const std::vector<std::vector<unsigned char>> binaries = program.getInfo<CL_PROGRAM_BINARIES>();
    std::optional<std::string> ptx;
    if (!binaries.empty())
      ptx = ptx_of_binary({reinterpret_cast<const char*>(binaries[0].data()), binaries[0].size()});
    if (!ptx)
      throw_input_error("--keep-ptx", fmt::format("{} makes no PTX", name_),
                        "a device whose OpenCL compiler does, as NVIDIA's");
    const std::string kernels = program.getInfo<CL_PROGRAM_KERNEL_NAMES>();
    std::filesystem::create_directories(ptx_folder_);
    const std::filesystem::path file = ptx_folder_ / (kernels.substr(0, kernels.find(';')) + ".ptx");
    if (!(std::ofstream(file, std::ios::binary) << *ptx))
      throw_input_error(file.string(), "cannot be written", "a folder to write to");
  }

  BuiltKernel& kernel(const KernelLaunch& launch) {
    Unit& unit = units_[launch.unit];
    const auto it = unit.kernels.find(launch.kernel);
    if (it != unit.kernels.end()) return it->second;
    const std::string names = unit.program.getInfo<CL_PROGRAM_KERNEL_NAMES>();
    if ((";" + names + ";").find(";" + launch.kernel + ";") == std::string::npos) {
      throw_input_error("kernels", fmt::format("no kernel '{}'", launch.kernel), names);
    }
    BuiltKernel built{cl::Kernel(unit.program, launch.kernel.c_str()), timings_.size()};
    timings_.push_back({launch.kernel, 0, 0});
    return unit.kernels.emplace(launch.kernel, std::move(built)).first->second;
  }

  std::string name_;
  std::filesystem::path ptx_folder_;  // empty: PTX is not kept
  cl::Device device_;
  SharedContext& shared_;
  cl::Context context_;
  cl::CommandQueue queue_;
  std::vector<Unit> units_;
  PerArray<cl::Buffer> buffers_;
  std::vector<std::pair<std::size_t, cl::Event>> running_;  // since the last finish()
  std::vector<KernelTiming> timings_;
};

}  // namespace

std::size_t count_opencl_devices() { return find_devices().size(); }

std::unique_ptr<ComputeDevice> open_opencl_device(const std::string& substring,
                                                  const std::vector<std::string>& extensions,
                                                  const std::string& ptx_folder) {
  const FoundDevice found = choose_device(substring);
  const std::string there = found.device.getInfo<CL_DEVICE_EXTENSIONS>();
  for (const std::string& extension : extensions)
    if (there.find(extension) == std::string::npos)
      throw_input_error("--device", fmt::format("{} has no {}", found.name, extension),
                        "a variant that does without, or another device");
  return std::make_unique<OpenclDevice>(found, ptx_folder);
}

}  // namespace warpgrain
