#pragma once
// Three-vectors of the reference. Eigen's fixed-size vectors are exactly three scalars, so arrays of them are
// packed.

#include <Eigen/Core>
#include <Eigen/Geometry>  // cross products

namespace warpgrain {

template <class Real>
using Vector3 = Eigen::Matrix<Real, 3, 1>;
using Vector3d = Vector3<double>;

}  // namespace warpgrain
