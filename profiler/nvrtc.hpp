#pragma once
// NVIDIA's run-time compiler of CUDA C++, opened where the system has one.

#include <optional>
#include <string>
#include <vector>

namespace warpgrain::profiler {

struct NvrtcResult {
  std::string version;  // "NVRTC 13.0"
  std::string ptx;      // empty: it does not compile
  std::string log;
};

// Nothing when there is no libnvrtc.
std::optional<NvrtcResult> compile_with_nvrtc(const std::string& source, const std::string& name,
                                              const std::vector<std::string>& options);

}  // namespace warpgrain::profiler
