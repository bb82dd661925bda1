#include "cli/accuracy/setting.hpp"

#include <fmt/format.h>

#include "variants/backend_simt.hpp"

namespace warpgrain::cli {

std::string AccuracyCase::name() const {
  return step_factor == 1 ? variant.name() : fmt::format("{}, {:g} x step", variant.name(), step_factor);
}

const Backend& AccuracyCase::runs_on() const {
  const bool is_default = variant.value(AxisId::math) == Variant().value(AxisId::math);
  return is_default && !always_simulated ? backend("opencl") : simt_approximate_backend;
}

Scene with_step(const Scene& scene, double step_factor) {
  Scene result = scene;
  result.time_step *= step_factor;
  return result;
}

}  // namespace warpgrain::cli
