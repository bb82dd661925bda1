#pragma once
// The overlap of two spheres, as exact as their positions and radii are.

#include <type_traits>

#include "core/vector3.hpp"

namespace warpgrain {

// reach - |apart| [m]: `reach` is the sum of the radii, `distance` > 0 the rounded length of `apart`. In a
// settled bed the two lengths agree to 4 or 5 digits, so that the rounding of a float distance would be
// thousandths of the overlap. In float the distance is therefore corrected by one Newton step of the square
// root; double holds the squares of floats exactly. kernels/overlap.h does the same in float arithmetic.
template <class Real>
Real overlap_of_spheres([[maybe_unused]] const Vector3<Real>& apart, Real distance, Real reach) {
  if constexpr (std::is_same_v<Real, float>) {
    const double length = distance;
    const double excess = length * length - apart.template cast<double>().squaredNorm();
    return (reach - distance) + static_cast<float>(excess / (2 * length));
  } else {
    return reach - distance;
  }
}

}  // namespace warpgrain
