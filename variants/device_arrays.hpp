#pragma once
// Names of the arrays that a step works on. What is in them: kernels/layout.h.

#include <array>
#include <cstddef>
#include <vector>

namespace warpgrain {

enum class DeviceArray : std::size_t {
  position_radius,
  velocity_mass,
  angular_velocity,
  rank_material,
  // Where a reorder writes; it becomes the array itself by a swap.
  position_radius_spare,
  velocity_mass_spare,
  angular_velocity_spare,
  rank_material_spare,
  force,
  torque,
  // After the evaluation of forces, and before it.
  contact_counts,
  history_partners,
  history_displacements,
  contact_counts_before,
  history_partners_before,
  history_displacements_before,
  cell_keys,
  cell_keys_spare,
  memory_keys,
  particle_of_rank,
  cell_ranges,
  scan_sums,
  near,
  near_counts,
  near_groups,
  listed_positions,
  lists_outdated,
  fixed_sums,
  contact_parameters,
  walls,
  status,
  count_
};
inline constexpr std::size_t n_device_arrays = static_cast<std::size_t>(DeviceArray::count_);

// A value for each array.
template <class T>
class PerArray {
 public:
  T& operator[](DeviceArray array) { return values_[static_cast<std::size_t>(array)]; }
  const T& operator[](DeviceArray array) const { return values_[static_cast<std::size_t>(array)]; }

 private:
  std::array<T, n_device_arrays> values_{};
};

}  // namespace warpgrain
