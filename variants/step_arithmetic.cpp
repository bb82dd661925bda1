#include "variants/step_arithmetic.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/scene_domain.hpp"
#include "variants/fixed_point.hpp"
#include "variants/precisions.hpp"

namespace warpgrain {

StepArithmetic step_arithmetic(const Scene& scene, const Variant& variant) {
  const Precision& precision = precision_of(variant);
  StepArithmetic arithmetic{std::string(precision.name), 0};
  const Box box = box_around(scene);
  const double farthest = std::max(box.lower.cwiseAbs().maxCoeff(), box.upper.cwiseAbs().maxCoeff());
  if (precision.has_fixed_places) {
    const double edge = 2 * std::ranges::max(scene.particles.radius);
    arithmetic.place_spacing = std::exp2(fixed_point_for(scene, edge).unit_exponent);
  } else if (precision.is_fp64) {
    arithmetic.place_spacing = std::nextafter(farthest, std::numeric_limits<double>::infinity()) - farthest;
  } else {
    const auto here = static_cast<float>(farthest);
    arithmetic.place_spacing = std::nextafter(here, std::numeric_limits<float>::infinity()) - here;
  }
  return arithmetic;
}

}  // namespace warpgrain
