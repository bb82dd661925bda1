#pragma once
// What a variant's step costs.

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>

#include "cli/accuracy/setting.hpp"
#include "profiler/profile.hpp"
#include "variants/step_profile.hpp"

namespace warpgrain::cli {

struct StepCost {
  std::uint64_t warp_instructions = 0;      // of one step, simulated
  std::uint64_t bytes = 0;                  // in the 32-byte sectors that its warps touch in global memory
  std::optional<double> seconds;            // of one step on the OpenCL device
  std::optional<double> predicted_seconds;  // of one step on the setting's machine, by the cost model
};
StepCost cost_of(const AccuracySetting& setting, const Variant& variant);

// Of a profiled step, which left that; none where the machine has no cost constants, or footprints were not
// counted.
std::optional<double> predicted_seconds(std::span<const profiler::LaunchProfile> launches,
                                        const ProfiledState& left, const Scene& scene,
                                        const Machine& machine);

// Steps that a device was measured at, a document a variant.
class MeasuredSteps {
 public:
  // Throws InputError for what is no measured step of a variant, for a variant that stands in two documents,
  // and for documents of different devices, scenes or numbers of particles.
  explicit MeasuredSteps(std::span<const std::string> files);

  // "NVIDIA H100, settled_bed, 131,072 particles"; empty without documents.
  const std::string& of_what() const { return of_what_; }
  // Median seconds of a step.
  std::optional<double> seconds(const Variant& variant) const;

 private:
  std::string of_what_;
  std::map<std::string, double> seconds_;  // by the variant's name
};

}  // namespace warpgrain::cli
