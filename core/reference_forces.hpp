#pragma once
// The oracle: forces of a state in double, by the reference solver.

#include <cstdint>

#include "core/particle_state.hpp"
#include "core/reference_solver.hpp"
#include "core/scene.hpp"

namespace warpgrain {

struct ForceEvaluation {
  ForceState forces;                // in the order of the state given
  std::uint64_t contact_count = 0;  // a pair once, a wall contact once
  ContactHistory contact_history;   // after the evaluation
};

// Forces and torques on `state`, in any order of its particles, in the scene's walls, materials and model.
// The state's contact_history is what eq. (7) starts from; `time_step` [s] is its dt. Throws SimulationError
// as ReferenceSolver::step does.
ForceEvaluation evaluate_forces(const Scene& scene, const ParticleState& state, double time_step,
                                const ReferenceOptions& options = {});

}  // namespace warpgrain
