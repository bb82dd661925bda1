#include "core/reference_solver.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <numeric>

#include "core/error.hpp"

namespace warpgrain {
namespace {

template <class Real>
ParticleArrays<Real> sorted_by_id(const ParticleState& state) {
  std::vector<std::size_t> order(state.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return state.id[a] < state.id[b]; });
  ParticleArrays<Real> arrays;
  for (std::size_t k : order) {
    if (!arrays.id.empty() && arrays.id.back() == state.id[k])
      throw_input_error("particles", fmt::format("id {} twice", state.id[k]), "unique ids");
    arrays.id.push_back(state.id[k]);
    arrays.material.push_back(state.material[k]);
    arrays.radius.push_back(static_cast<Real>(state.radius[k]));
    arrays.mass.push_back(static_cast<Real>(state.mass[k]));
    arrays.position.push_back(state.position[k].cast<Real>());
    arrays.velocity.push_back(state.velocity[k].cast<Real>());
    arrays.angular_velocity.push_back(state.angular_velocity[k].cast<Real>());
  }
  return arrays;
}

template <class Real>
double skin_of(const ParticleArrays<Real>& particles) {
  // Wide enough that a list lasts some tens of steps, narrow enough that few candidates do not touch; the
  // share of the radius is that of LAMMPS inputs for such beds.
  if (particles.radius.empty()) return 0;
  return 0.4 * *std::min_element(particles.radius.begin(), particles.radius.end());
}

template <class Real>
std::vector<Vector3d> as_double(const std::vector<Vector3<Real>>& vectors) {
  std::vector<Vector3d> result;
  result.reserve(vectors.size());
  for (const Vector3<Real>& v : vectors) result.push_back(v.template cast<double>());
  return result;
}

}  // namespace

template <class Real>
ReferenceSolver<Real>::ReferenceSolver(const Scene& scene, const ReferenceOptions& options)
    : ReferenceSolver(scene, make_force_terms<Real>(scene), options) {}

template <class Real>
ReferenceSolver<Real>::ReferenceSolver(const Scene& scene, ForceTermList<Real> terms,
                                       const ReferenceOptions& options)
    : terms_(std::move(terms)),
      domain_(scene.domain),
      time_step_(static_cast<Real>(scene.time_step)),
      particles_(sorted_by_id<Real>(scene.particles)),
      ranges_(split_ranges(particles_.id.size(), options.threads)),
      neighbours_(scene.domain, scene.walls, particles_.radius, skin_of(particles_), ranges_),
      contact_forces_(scene, ranges_, options.contact_slots) {
  contact_forces_.set_history(scene.particles.contact_history, particles_);
  try {
    for (std::size_t i = 0; i < particles_.id.size(); ++i) require_inside(i);
    neighbours_.build(particles_.position);
    evaluate();
  } catch (const SimulationError& e) {
    throw_simulation_error("step 0", e.what());
  }
}

template <class Real>
void ReferenceSolver<Real>::step(std::uint64_t n) {
  for (std::uint64_t k = 0; k < n; ++k) try {
      integrate();
      evaluate();
      ++steps_done_;
    } catch (const SimulationError& e) {
      throw_simulation_error(fmt::format("step {}", steps_done_ + 1), e.what());
    }
}

template <class Real>
void ReferenceSolver<Real>::integrate() {
  std::vector<char> outdated(ranges_.size(), 0);
  const auto built_at = neighbours_.built_at();
  for_each_range(ranges_.size(), [&](std::size_t range) {
    ParticleArrays<Real>& p = particles_;
    for (std::size_t i = ranges_[range].first; i < ranges_[range].last; ++i) {
      const Real inertia = Real(0.4) * p.mass[i] * p.radius[i] * p.radius[i];
      p.velocity[i] += p.force[i] * (time_step_ / p.mass[i]);
      p.angular_velocity[i] += p.torque[i] * (time_step_ / inertia);
      p.position[i] += p.velocity[i] * time_step_;
      require_inside(i);
      if (neighbours_.outdated_by((p.position[i] - built_at[i]).squaredNorm())) outdated[range] = 1;
    }
  });
  if (std::count(outdated.begin(), outdated.end(), 1)) neighbours_.build(particles_.position);
}

template <class Real>
void ReferenceSolver<Real>::evaluate() {
  contact_forces_.evaluate(terms_, neighbours_, time_step_, particles_);
}

template <class Real>
void ReferenceSolver<Real>::require_inside(std::size_t i) const {
  const Vector3<Real>& x = particles_.position[i];
  const Vector3<Real> lower = domain_.lower.template cast<Real>(),
                      upper = domain_.upper.template cast<Real>();
  // Written so that NaN is outside.
  const bool inside = (x.array() >= lower.array()).all() && (x.array() <= upper.array()).all();
  if (!inside)
    throw_simulation_error(
        fmt::format("particle {}", particles_.id[i]),
        fmt::format("left the domain, at ({}, {}, {})", x.x(), x.y(), x.z()),
        fmt::format("a place between ({}, {}, {}) and ({}, {}, {})", domain_.lower.x(), domain_.lower.y(),
                    domain_.lower.z(), domain_.upper.x(), domain_.upper.y(), domain_.upper.z()));
}

template <class Real>
ParticleState ReferenceSolver<Real>::state() const {
  ParticleState state;
  state.id = particles_.id;
  state.material = particles_.material;
  state.radius.assign(particles_.radius.begin(), particles_.radius.end());
  state.mass.assign(particles_.mass.begin(), particles_.mass.end());
  state.position = as_double(particles_.position);
  state.velocity = as_double(particles_.velocity);
  state.angular_velocity = as_double(particles_.angular_velocity);
  state.contact_history = contact_forces_.history_before(particles_);
  return state;
}

template <class Real>
ForceState ReferenceSolver<Real>::forces() const {
  return {as_double(particles_.force), as_double(particles_.torque)};
}

template <class Real>
ContactHistory ReferenceSolver<Real>::contact_history() const {
  return contact_forces_.history_after(particles_);
}

template class ReferenceSolver<float>;
template class ReferenceSolver<double>;

}  // namespace warpgrain
