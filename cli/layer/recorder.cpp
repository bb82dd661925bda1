#include "cli/layer/recorder.hpp"

#include <algorithm>
#include <exception>
#include <fmt/format.h>
#include <fnmatch.h>
#include <iostream>

namespace warpgrain::layer {

Recorder::Recorder(const cl_icd_dispatch& cl, const cli::RecordSettings& settings)
    : settings_(settings), folder_(settings.folder, settings.memory), capturing_(cl, handles) {}

bool Recorder::is_named(const std::string& kernel) const {
  const auto fits = [&](const std::string& pattern) {
    return fnmatch(pattern.c_str(), kernel.c_str(), 0) == 0;
  };
  return settings_.kernels.empty() || std::ranges::any_of(settings_.kernels, fits);
}

bool Recorder::is_next(const std::string& kernel) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t index = launches_[kernel]++;
  return index % settings_.every == 0 && index / settings_.every < settings_.first;
}

bool Recorder::is_too_large(const Enqueued& launch) const {
  return launch.dimensions >= 1 && launch.dimensions <= 3 && launch.global_size != nullptr &&
         launch.work_items() > settings_.largest;
}

Capture Recorder::capture(const Kernel& kernel, const Enqueued& launch) const {
  if (open_user_events_ != 0) return {.unprofiled = "the application has yet to set a user event"};
  if (!folder_.has_room_for(capturing_.buffer_bytes(kernel)))
    return {.unprofiled = fmt::format("recorded buffers may take {} MiB", settings_.memory >> 20)};
  return capturing_.capture(kernel, launch);
}

std::optional<PendingLaunch> Recorder::capture(const Enqueued& launch) noexcept {
  std::optional<PendingLaunch> pending;
  try {
    std::optional<Kernel> kernel = kernels.find(launch.kernel);
    if (!kernel || !is_named(kernel->name)) return std::nullopt;
    const bool too_large = is_too_large(launch);
    if (!too_large && !is_next(kernel->name)) return std::nullopt;
    pending.emplace(PendingLaunch{std::move(*kernel), {}});
    if (too_large)
      pending->capture.unprofiled = fmt::format("more than {} work-items", settings_.largest);
    else
      pending->capture = capture(pending->kernel, launch);
  } catch (const std::exception& error) {
    if (pending) pending->capture = {.unprofiled = error.what()};
  }
  return pending;
}

void Recorder::keep(const PendingLaunch& launch) noexcept {
  try {
    const Capture& captured = launch.capture;
    if (!captured.unprofiled.empty()) return folder_.add_unrecorded(launch.kernel.name, captured.unprofiled);
    profiler::LaunchFile file;
    file.program = folder_.add_program(launch.kernel.program);
    file.kernel = launch.kernel.name;
    file.shape = captured.shape;
    for (const CapturedArgument& argument : captured.arguments) {
      file.arguments.push_back(argument.is_buffer ? folder_.add_buffer(argument.bytes) : argument.argument);
      file.arguments.back().read_only = argument.read_only;
    }
    folder_.add_launch(std::move(file), captured.remark);
  } catch (const std::exception& error) {
    std::cerr << "warpgrain record: " << error.what() << '\n';
  }
}

}  // namespace warpgrain::layer
