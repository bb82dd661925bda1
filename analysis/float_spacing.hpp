#pragma once
// Errors in units in the last place.

namespace warpgrain {

// `error` in distances between neighbouring floats at `value`; 0 for a value of 0.
double in_float_ulps(double error, double value);

}  // namespace warpgrain
