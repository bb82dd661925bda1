#pragma once
// What grains that have flowed through a slit are asked about: how fast they came, and what lies there.

#include <span>
#include <vector>

#include "core/vector3.hpp"

namespace warpgrain {

// How many had passed at a time.
struct PassedAt {
  double time = 0;  // s
  double passed = 0;
};
// Grains a second between when `from` and when `to` had passed, both interpolated. Throws InputError when so
// many never passed; the samples are in order of time and never fall.
double flow_rate(std::span<const PassedAt> samples, double from, double to);

// The slope of a heap that has its top at x = 0, as an angle [degrees]: of the line of least squares through
// the highest grains in bins of |x| one diameter wide, from the second bin to the last that has grains above
// the first layer. `floor` is the z that grains lie on. Throws InputError where there are no two such bins.
double repose_angle(std::span<const Vector3d> positions, double radius, double floor);

// The part of a box that spheres of one radius fill whose centres are in it.
double packing_fraction(std::span<const Vector3d> positions, double radius, const Vector3d& lower,
                        const Vector3d& upper);

}  // namespace warpgrain
