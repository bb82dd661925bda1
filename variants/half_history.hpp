#pragma once
// Tangential displacements in half precision, as precision `fp16_history` stores them in contact slots
// (kernels/contact_history.h).

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/vector3.hpp"

namespace warpgrain {

// In units of a power of two of a metre, so that two of the smallest radii are the largest displacement, and
// displacements down to 4e-9 of that radius are held to 11 bits.
class HalfHistory {
 public:
  explicit HalfHistory(double smallest_radius);

  bool can_store(const Vector3d& displacement) const;
  // Three numbers a vector, to nearest.
  std::vector<std::byte> stored(const std::vector<Vector3d>& displacements) const;
  std::vector<double> lengths(std::span<const std::uint16_t> halves) const;
  // -D options of the kernels.
  std::string build_options() const;

 private:
  int unit_exponent_;
};

}  // namespace warpgrain
