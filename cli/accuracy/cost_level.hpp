#pragma once
// What a variant's step costs.

#include <cstdint>
#include <optional>

#include "cli/accuracy/setting.hpp"

namespace warpgrain::cli {

struct StepCost {
  std::uint64_t warp_instructions = 0;  // of one step, simulated
  std::uint64_t bytes = 0;              // in the 32-byte sectors that its warps touch in global memory
  std::optional<double> seconds;        // of one step on the OpenCL device
};
StepCost cost_of(const AccuracySetting& setting, const Variant& variant);

}  // namespace warpgrain::cli
