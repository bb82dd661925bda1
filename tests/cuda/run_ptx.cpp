// The test driver's device: the simulator.

#include <cstring>
#include <exception>
#include <iostream>
#include <map>
#include <memory>
#include <vector>

#include "profiler/executable.hpp"
#include "profiler/kernel_signature.hpp"

using namespace warpgrain::profiler;

// Exported for libcuda.so.1 of tests/cuda/driver.
extern "C" __attribute__((visibility("default"))) int warpgrain_test_launch(const char* ptx,
                                                                            const char* kernel,
                                                                            const unsigned* groups,
                                                                            const unsigned* group_size,
                                                                            unsigned, void** parameters) {
  try {
    static std::map<std::pair<std::string, std::string>, std::unique_ptr<Executable>> compiled;
    auto& executable = compiled[{ptx, kernel}];
    if (!executable) executable = Executable::compile(ptx, kernel, TraceMode::none, "test driver");
    std::vector<KernelArgument> arguments;
    for (const KernelParameter& parameter : executable->parameters()) {
      const auto* const value = static_cast<const std::byte*>(parameters[arguments.size()]);
      if (parameter.pointer == KernelParameter::Pointer::none) {
        arguments.push_back(KernelArgument::scalar({value, parameter.bytes}));
      } else {
        std::byte* address = nullptr;
        std::memcpy(&address, value, sizeof address);
        // Of how many bytes nobody asks where nothing is checked.
        arguments.push_back(KernelArgument::buffer({address, address == nullptr ? 0u : 1u}));
      }
    }
    LaunchShape shape;
    for (std::size_t d = 0; d < 3; ++d) {
      shape.local_size[d] = group_size[d];
      shape.global_size[d] = std::uint64_t{groups[d]} * group_size[d];
    }
    const auto runner = executable->runner(shape, arguments);
    for (std::uint64_t z = 0; z < groups[2]; ++z)
      for (std::uint64_t y = 0; y < groups[1]; ++y)
        for (std::uint64_t x = 0; x < groups[0]; ++x) runner->run({x, y, z});
    return 0;
  } catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
