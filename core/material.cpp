#include "core/material.hpp"

#include <cmath>
#include <fmt/format.h>
#include <numbers>

#include "core/error.hpp"

namespace warpgrain {

double effective_youngs_modulus(const Material& i, const Material& j) {
  const double compliance = (1 - i.poisson_ratio * i.poisson_ratio) / i.youngs_modulus +
                            (1 - j.poisson_ratio * j.poisson_ratio) / j.youngs_modulus;
  return 1 / compliance;
}

double effective_shear_modulus(const Material& i, const Material& j) {
  const double compliance = 2 * (2 - i.poisson_ratio) * (1 + i.poisson_ratio) / i.youngs_modulus +
                            2 * (2 - j.poisson_ratio) * (1 + j.poisson_ratio) / j.youngs_modulus;
  return 1 / compliance;
}

double damping_parameter_of_restitution(double restitution) {
  if (!(restitution > 0 && restitution <= 1))
    throw_input_error("restitution", fmt::format("{}", restitution), "a number in (0, 1]");
  const double log_e = std::log(restitution);
  return -std::sqrt(5.0) * log_e / std::hypot(std::numbers::pi, log_e);
}

}  // namespace warpgrain
