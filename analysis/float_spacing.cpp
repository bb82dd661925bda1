#include "analysis/float_spacing.hpp"

#include <cmath>

namespace warpgrain {

double in_float_ulps(double error, double value) {
  if (value == 0) return 0;
  return error / std::exp2(std::ilogb(value) - 23);
}

}  // namespace warpgrain
