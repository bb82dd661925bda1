#pragma once
// Which launches of an application are recorded, and their way into the folder.

#include <CL/cl_icd.h>
#include <atomic>
#include <cstdint>
#include <map>
#include <mutex>
#include <optional>
#include <string>

#include "cli/layer/capture.hpp"
#include "cli/layer/kernels.hpp"
#include "cli/layer/launch_folder.hpp"
#include "cli/layer/programs.hpp"
#include "cli/record_settings.hpp"

namespace warpgrain::layer {

// A launch between its capture and its start.
struct PendingLaunch {
  Kernel kernel;
  Capture capture;
};

// Thread safe. Nothing that happens here reaches the application: what cannot be recorded is noted in the
// folder, by the kernel's name.
class Recorder {
 public:
  Recorder(const cl_icd_dispatch& cl, const cli::RecordSettings& settings);

  // Before the launch goes to the device. None for launches that nobody asked for.
  std::optional<PendingLaunch> capture(const Enqueued& launch) noexcept;
  // After it has gone there.
  void keep(const PendingLaunch& launch) noexcept;

  // While events wait for the application itself, nothing that may wait for them can be waited for.
  void user_event_made() { ++open_user_events_; }
  void user_event_set() { --open_user_events_; }

  Handles handles;
  Programs programs;
  Kernels kernels{handles};

 private:
  bool is_named(const std::string& kernel) const;
  bool is_next(const std::string& kernel);
  bool is_too_large(const Enqueued& launch) const;
  Capture capture(const Kernel& kernel, const Enqueued& launch) const;

  const cli::RecordSettings settings_;
  LaunchFolder folder_;
  Capturing capturing_;
  std::atomic<int> open_user_events_ = 0;
  std::mutex mutex_;
  std::map<std::string, std::uint64_t> launches_;  // so far, by kernel
};

}  // namespace warpgrain::layer
