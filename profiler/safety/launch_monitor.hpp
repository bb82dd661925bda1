#pragma once
// What the runners of one launch share: its memory, its limits, and what they found.

#include <atomic>
#include <map>
#include <mutex>
#include <span>
#include <string>
#include <tuple>
#include <vector>

#include "profiler/diagnostic.hpp"
#include "profiler/safety/launch_memory.hpp"
#include "profiler/translated_kernel.hpp"

namespace warpgrain::profiler {

class LaunchMonitor {
 public:
  // Shape and arguments have been checked; kernel and arguments outlive the monitor.
  LaunchMonitor(const TranslatedKernel& kernel, const LaunchShape& shape,
                std::span<const KernelArgument> arguments, const RunLimits& limits);

  const TranslatedKernel& kernel() const { return kernel_; }
  const LaunchShape& shape() const { return shape_; }
  std::span<const KernelArgument> arguments() const { return arguments_; }
  const RunLimits& limits() const { return limits_; }
  const LaunchMemory& memory() const { return memory_; }

  // Of a work-group: its number in the launch.
  std::uint64_t number_of(const std::array<std::uint64_t, 3>& group) const;
  // Work-item and work-group of the diagnostic, from a work-item's number in the launch, counted group by
  // group from 0.
  void set_item(Diagnostic& diagnostic, std::uint64_t item) const;
  std::array<std::uint64_t, 3> global_id(std::uint64_t item) const;

  // Notes something found at `ptx_line` by a work-item. Of what is found again only the count is kept, and
  // the lowest work-item's version. `make` fills in the rest.
  template <class Make>
  void note(DiagnosticKind kind, std::uint32_t ptx_line, std::uint32_t object, std::uint64_t item,
            Make&& make) {
    const std::lock_guard lock(mutex_);
    Entry& entry = found_[{ptx_line, kind, object}];
    ++entry.count;
    if (item >= entry.item) return;
    entry.item = item;
    entry.diagnostic = Diagnostic{};
    entry.diagnostic.kind = kind;
    entry.diagnostic.place = kernel_.source_of(ptx_line);
    set_item(entry.diagnostic, item);
    make(entry.diagnostic);
  }
  // By place.
  std::vector<Diagnostic> diagnostics() const;

  // A work-item was stopped.
  void note_stopped() { ++stopped_; }
  bool given_up() const { return stopped_ >= limits_.max_stopped; }

 private:
  struct Entry {
    std::uint64_t count = 0;
    std::uint64_t item = ~std::uint64_t{0};
    Diagnostic diagnostic;
  };

  const TranslatedKernel& kernel_;
  LaunchShape shape_;
  std::span<const KernelArgument> arguments_;
  RunLimits limits_;
  LaunchMemory memory_;
  std::atomic<std::uint32_t> stopped_ = 0;
  mutable std::mutex mutex_;
  std::map<std::tuple<std::uint32_t, DiagnosticKind, std::uint32_t>, Entry> found_;
};

}  // namespace warpgrain::profiler
