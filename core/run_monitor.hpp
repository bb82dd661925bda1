#pragma once
// Looks at the states that a run passes through for what a run must not go on with unnoticed. Kernels report
// what they see themselves (particles that leave the domain, full contact slots, forces that are no numbers);
// this is for what only shows in a whole state, so it costs nothing between two looks.

#include <cstdint>
#include <string>
#include <vector>

#include "core/energy.hpp"
#include "core/particle_state.hpp"
#include "core/scene.hpp"

namespace warpgrain {

struct MonitorLimits {
  // Overlap as a part of the smaller radius. Hertz's theory asks for contacts small beside the spheres: at
  // 0.2 of two equal ones the contact circle's radius is already 0.63 of the effective radius. At 1 the
  // centre of one lies on the other's surface, and the force no longer says which way is out.
  double overlap_warning = 0.2, overlap_error = 1;
  // Total energy above the least seen so far, as a part of the largest kinetic and elastic energy seen:
  // nothing in a scene gives energy, so that all growth is the integration's or the arithmetic's. What
  // rounding a mass to float makes of the energy of place, 1e-6 of the whole weight times the size of the
  // domain, is none.
  double energy_warning = 0.05, energy_error = 0.5;
};

class RunMonitor {
 public:
  explicit RunMonitor(const Scene& scene, const MonitorLimits& limits = {});

  // Returns warnings, each a line that names step and particle, each kind once in a monitor's life. Throws
  // SimulationError with such a line for a number that is not finite, a particle outside of the domain, an
  // overlap or a growth of energy beyond the limits. `state` is the scene's particles at `step`.
  std::vector<std::string> look(std::uint64_t step, const ParticleState& state);
  // Of the state last looked at.
  const Energy& energy() const { return energy_; }

 private:
  void require_numbers(std::uint64_t step, const ParticleState& state) const;
  void judge_overlap(std::uint64_t step, const DeepestContact& deepest, std::vector<std::string>& warnings);
  void judge_energy(std::uint64_t step, const ParticleState& state, std::vector<std::string>& warnings);

  Scene scene_;  // without its particles
  MonitorLimits limits_;
  Energy energy_;
  bool has_looked_ = false, warned_of_overlap_ = false, warned_of_energy_ = false;
  double least_total_ = 0, largest_internal_ = 0;  // J, places counted from the middle of the domain
};

}  // namespace warpgrain
