#pragma once
// The C++ reference: the scene's model in double or float from one source. Forces are a list of terms
// (force_term.hpp). Semi-implicit Euler: v += dt F/m, then x += dt v; the same for the angular velocity with
// I = 2/5 m r^2. Results are the same bits for every number of threads and at every repetition.

#include <cstddef>
#include <cstdint>

#include "core/contact_forces.hpp"
#include "core/force_term.hpp"
#include "core/neighbour_list.hpp"
#include "core/scene.hpp"

namespace warpgrain {

struct ReferenceOptions {
  unsigned threads = 0;            // 0: all cores
  std::size_t contact_slots = 16;  // simultaneous contacts a particle may have
};

template <class Real>
class ReferenceSolver {
 public:
  // Both evaluate the forces once, with the history in scene.particles. Throw SimulationError as step() does.
  explicit ReferenceSolver(const Scene& scene, const ReferenceOptions& options = {});
  ReferenceSolver(const Scene& scene, ForceTermList<Real> terms, const ReferenceOptions& options = {});

  // n times: integrate, then evaluate the forces at the new positions. Throws SimulationError naming step and
  // particle when one leaves the domain, runs out of contact slots, meets another's very centre or turns NaN.
  void step(std::uint64_t n = 1);

  // Sorted by id; the history is the one before the last evaluation (particle_state.hpp).
  ParticleState state() const;
  ForceState forces() const;               // in the order of state()
  ContactHistory contact_history() const;  // as the last evaluation left it
  std::uint64_t contact_count() const {
    return contact_forces_.contact_count();
  }  // a pair once, a wall contact once
  std::uint64_t steps_done() const { return steps_done_; }
  std::uint64_t neighbour_list_builds() const { return neighbours_.builds(); }

  // Changes take effect at the next evaluation.
  ForceTermList<Real>& terms() { return terms_; }

 private:
  void integrate();
  void evaluate();
  void require_inside(std::size_t particle) const;

  ForceTermList<Real> terms_;
  Box domain_;
  Real time_step_;
  ParticleArrays<Real> particles_;
  std::vector<IndexRange> ranges_;
  NeighbourList<Real> neighbours_;
  ContactForces<Real> contact_forces_;
  std::uint64_t steps_done_ = 0;
};

}  // namespace warpgrain
