#pragma once
// When a run has come to rest: no particle has moved farther than a set displacement over a window of steps.

#include <cstdint>
#include <span>
#include <vector>

#include "core/scene.hpp"
#include "core/vector3.hpp"

namespace warpgrain {

class RestCriterion {
 public:
  // The first window begins at `step` with these positions [n_particles].
  RestCriterion(const RunEnd::AtRest& limits, std::uint64_t step, std::span<const Vector3d> positions);

  // Whether everything is at rest at `step`, positions being in the same order as before. May be called at
  // any steps, ascending: once a call finds a particle too far from its place at the window's begin, a new
  // window begins there.
  bool update(std::uint64_t step, std::span<const Vector3d> positions);

  double displacement() const {
    return displacement_;
  }  // m, the largest within the window, as of the last call

 private:
  RunEnd::AtRest limits_;
  std::uint64_t window_begin_;
  std::vector<Vector3d> begin_positions_;
  double displacement_ = 0;
};

}  // namespace warpgrain
