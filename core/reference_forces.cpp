#include "core/reference_forces.hpp"

#include <algorithm>

namespace warpgrain {

ForceEvaluation evaluate_forces(const Scene& scene, const ParticleState& state, double time_step,
                                const ReferenceOptions& options) {
  Scene at_state = scene;
  at_state.particles = state;
  at_state.time_step = time_step;
  const ReferenceSolver<double> solver(at_state, options);

  ForceEvaluation result;
  const ForceState by_id = solver.forces();
  const std::vector<std::uint32_t> ids = solver.state().id;
  for (std::uint32_t id : state.id) {
    const std::size_t k = std::lower_bound(ids.begin(), ids.end(), id) - ids.begin();
    result.forces.force.push_back(by_id.force[k]);
    result.forces.torque.push_back(by_id.torque[k]);
  }
  result.contact_count = solver.contact_count();
  result.contact_history = solver.contact_history();
  return result;
}

}  // namespace warpgrain
