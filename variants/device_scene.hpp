#pragma once
// A scene as a device holds it: sizes, kernel parameters, and what the arrays hold before the first
// evaluation.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "core/particle_state.hpp"
#include "core/scene.hpp"
#include "variants/axes.hpp"
#include "variants/device_arrays.hpp"
#include "variants/fixed_point.hpp"
#include "variants/half_history.hpp"
#include "variants/scene_features.hpp"

namespace warpgrain {

struct DeviceScene {
  bool is_fp64 = false;
  std::optional<FixedPoint> fixed_point;  // of places, where they are not floating
  bool keeps_history = false;
  std::optional<HalfHistory> half_history;  // where displacements are not stored as reals
  std::uint32_t contact_slots = 0;          // of a particle; 0 without history
  SceneFeatures features;
  std::uint32_t n_particles = 0;
  std::uint32_t n_keys = 0;       // n_particles padded to a power of two, at least a block of the sort
  std::uint32_t n_cells = 0;      // numbers of cells
  std::uint32_t list_slots = 0;   // of a particle's list of partners; 0 where the search makes none
  std::uint32_t group_slots = 0;  // of a group's list of groups
  std::array<std::uint32_t, 3> n_cells_along{};
  bool map_points = false;       // particles are found through the map, not at their places in it
  double skin = 0;               // of lists that outlive a step [m]
  std::uint32_t work_group = 0;  // work-items of a work-group of kernels that work on particles
  double quanta_per_force = 1, quanta_per_torque = 1;  // of fixed-point sums
  std::vector<std::byte> parameters;                   // layout::StepParameters of the precision
  PerArray<std::size_t> bytes;                         // 0: the array is not used
  PerArray<std::vector<std::byte>> contents;           // [bytes]; empty: need not be written
};

// Throws InputError for a scene that no device can hold, SimulationError when a particle's contact history
// does not fit its slots.
DeviceScene lay_out(const Scene& scene, const Variant& variant);

// What the arrays of a device take.
std::size_t device_bytes(const DeviceScene& device);

// Contact slots that no particle can run out of while overlaps are small: how many spheres of the smallest
// radius touch one of the largest, and three walls.
std::uint32_t contact_slots_for(const ParticleState& particles);

}  // namespace warpgrain
