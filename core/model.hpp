#pragma once
// Which model a scene asks for, with what the paper leaves open as named options.

#include <array>
#include <string_view>

namespace warpgrain {

enum class ContactModel { simple, practical };
// What happens to delta_t when eq. (5) cuts the tangential force to F_cut.
enum class SlipHistory {
  clip,     // delta_t := -F_cut / k_t; converges as dt -> 0 (default)
  paper,    // to the letter: the force is cut, delta_t goes on adding up
  lammps,   // delta_t := -(F_cut + eta v_t) / k_t
  liggghts  // eq. (5) tests the spring part alone, no tangential damping while slipping, delta_t := -F_cut /
            // k_t
};
enum class NormalForce {
  signed_,   // the paper: damping may pull shortly before separation (default)
  repulsive  // F_n is never allowed to pull
};

// Coefficients of eq. (1), constant over the scene.
struct SimpleParameters {
  double k_spring = 0;   // N/m
  double k_damping = 0;  // N s/m
  double k_shear = 0;    // N s/m
};

struct ModelOptions {
  ContactModel contact = ContactModel::practical;
  SlipHistory slip_history = SlipHistory::clip;
  NormalForce normal_force = NormalForce::signed_;
  SimpleParameters simple;
};

inline constexpr std::array<std::string_view, 2> contact_model_names{"simple", "practical"};
inline constexpr std::array<std::string_view, 4> slip_history_names{"clip", "paper", "lammps", "liggghts"};
inline constexpr std::array<std::string_view, 2> normal_force_names{"signed", "repulsive"};

}  // namespace warpgrain
