#pragma once
// The parts of the model that a scene needs: with --model needed, kernels are compiled for those alone.
//
// Why nothing is lost. Every rule below reads only what no step of a run changes: materials, radii, masses,
// walls, gravity, options of the model. What a scene does without at its start, it does without for ever, so
// that no feature can become needed while it runs; a state that is handed over comes with its scene, from
// which the features are derived anew. Positions, velocities and spins appear in no rule.
//
// "Pairs" are those of materials that may touch: of two particles, or of a particle and a wall. With mu,
// alpha and C_kt of a pair as in core/material.hpp, the practical model needs
// * friction where the tangential force of some pair can differ from zero. It is cut to mu |F_n| (eq. 5),
//   and it is a sum of -k_t delta_t, k_t ~ C_kt, and -eta v_t, eta ~ alpha (eqs. 4, 9, 10). So it is zero
//   where mu = 0, and where both C_kt = 0 and alpha = 0. With slip_history liggghts eq. (5) tests the
//   spring alone and leaves the damping in a contact whose spring exerts nothing: there mu = 0 is not
//   enough, alpha has to be 0 as well.
// * rotation where there is friction: torques are r (n x F_t) (eq. 3), so that without F_t spins stay what
//   they were at the start, and eq. (6), where they matter, gives only F_t. state() returns the spins of
//   the scene.
// * history where there is friction in some pair with C_kt > 0: delta_t is read by -k_t delta_t alone.
// * damping where alpha > 0 in some pair: eta = alpha sqrt(k_n m*).
// * repulsion with normal_force repulsive, and damping: without it F_n = k_n overlap is never negative.
// * gravity where it is not zero.
// * radii, masses where there are several. One is a constant of the kernels, and with it R*, m* and all
//   that is computed of them; the host computes these in the precision of the variant, in the order in
//   which the kernels would.
// * pair_materials where pairs of two particles have different parameters; equal ones are constants.
// * wall_materials, the same of a particle and a wall.
// * planes, rectangles where there are walls of that kind; their number is a constant. Without walls a
//   step has no kernel for them.
// The simple model, eq. (1), keeps no spins and no history and reads no materials: rotation, history,
// repulsion, pair_materials and wall_materials are never needed. Its friction is the shear, k_shear > 0, its
// damping k_damping > 0.
//
// How exact. What is left out would have added a zero, or read again what is a constant, so that both models
// give the same bits wherever division rounds as IEEE 754 has it. Two things differ below what floats
// resolve: where the square of a tangential force underflows, eq. (5) does not see it, and the full model
// keeps a force below 1.1e-19 N (float; 1.5e-154 N double). And where division is less exact (OpenCL
// allows 2.5 units in the last place, the axis `math` more), R*, m* and 1/m of the full model are that much
// off, which changes a contact force by less than 1e-6 of itself (float).

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene.hpp"
#include "variants/axes.hpp"

namespace warpgrain {

enum class FeatureId : std::size_t {
  rotation,
  friction,
  history,
  damping,
  repulsion,
  gravity,
  radii,
  masses,
  pair_materials,
  wall_materials,
  planes,
  rectangles,
  count_
};
inline constexpr std::size_t n_features = static_cast<std::size_t>(FeatureId::count_);

struct Feature {
  std::string_view name;
  bool is_needed = false;    // by the scene and the variant's contact law
  bool is_modelled = false;  // by the kernels: needed, or the variant has the full model
  std::string why;           // it is needed or not, in a few words
};

// A row a feature.
class SceneFeatures {
 public:
  const std::array<Feature, n_features>& rows() const { return rows_; }
  bool model(FeatureId feature) const { return rows_[static_cast<std::size_t>(feature)].is_modelled; }
  bool model_walls() const { return model(FeatureId::planes) || model(FeatureId::rectangles); }
  // Whether some kernels ask which materials touch.
  bool store_materials() const {
    return model(FeatureId::pair_materials) || model(FeatureId::wall_materials);
  }
  // READS_MOTION of kernels/features.h, in kernels that begin sums with gravity and in those of walls.
  bool read_motion() const {
    return read_motion_at_walls() || (model(FeatureId::gravity) && model(FeatureId::masses));
  }
  bool read_motion_at_walls() const { return model(FeatureId::friction) || model(FeatureId::damping); }
  // Build options: of the kernels that move particles; of those that apply the law, between particles or at
  // walls. Nothing is said of what is modelled.
  std::string grid_options() const;
  std::string pair_options() const;
  std::string wall_options() const;

 private:
  friend class FeatureRules;
  std::array<Feature, n_features> rows_;
  std::optional<std::size_t> n_walls_;  // where kernels are compiled for that number
};

// Of the value that the variant has on the axis `model`.
SceneFeatures features_of(const Scene& scene, const Variant& variant);

}  // namespace warpgrain
