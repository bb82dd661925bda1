// What composing the force from terms costs: one force evaluation of the reference against a loop that a
// person fused by hand for the same physics (practical model, slip rule `clip`, gravity), and whole steps of
// the reference.

#include "core/reference_solver.hpp"

#include <algorithm>
#include <benchmark/benchmark.h>
#include <cmath>

#include "core/scene.hpp"

namespace warpgrain {
namespace {

// A sheared bed with some 1.5 contacts a particle, many of them slipping.
const Scene& bed() {
  static const Scene scene = [] {
    Scene sheared = load_scene("shear_box");
    ReferenceSolver<double> solver(sheared);
    solver.step(2000);
    sheared.particles = solver.state();
    return sheared;
  }();
  return scene;
}

struct Evaluation {
  ParticleArrays<double> particles;
  std::vector<IndexRange> ranges;
  NeighbourList<double> neighbours;

  explicit Evaluation(const Scene& scene)
      : ranges{{0, scene.particles.size()}},
        neighbours(scene.domain, scene.walls, scene.particles.radius, 0.4 * scene.particles.radius[0],
                   ranges) {
    const ParticleState& p = scene.particles;
    particles = {p.id,
                 p.material,
                 p.radius,
                 p.mass,
                 p.position,
                 p.velocity,
                 p.angular_velocity,
                 std::vector<Vector3d>(p.size()),
                 std::vector<Vector3d>(p.size())};
    neighbours.build(particles.position);
  }
};

// The fused loop. Its history lies beside the candidates: no search is needed, at the price of a list that
// cannot change.
class FusedForces {
 public:
  FusedForces(const Scene& scene, const Evaluation& at)
      : scene_(scene), displacement_(at.neighbours.rows(0).partner.size(), Vector3d::Zero()) {}

  void evaluate(Evaluation& at) {
    ParticleArrays<double>& p = at.particles;
    for (std::size_t i = 0; i < p.id.size(); ++i) {
      p.force[i] = scene_.gravity * p.mass[i];
      p.torque[i].setZero();
    }
    const PartnerRows& rows = at.neighbours.rows(0);
    for (std::size_t i = 0; i < p.id.size(); ++i)
      for (std::uint32_t k = rows.row_start[i]; k < rows.row_start[i + 1]; ++k)
        if (rows.partner[k] & wall_partner_bit)
          touch_wall(p, i, scene_.walls[rows.partner[k] & ~wall_partner_bit], displacement_[k]);
        else
          touch_particle(p, i, rows.partner[k], displacement_[k]);
  }

 private:
  void touch_wall(ParticleArrays<double>& p, std::size_t i, const Wall& wall, Vector3d& displacement) const {
    const auto near = wall_proximity(wall, p.position[i]);
    const double overlap = p.radius[i] - near.distance;
    if (!(overlap > 0)) {
      displacement.setZero();
      return;
    }
    const Vector3d n = near.contact_normal, spin = p.radius[i] * p.angular_velocity[i];
    Vector3d tangential;
    p.force[i] += law(p.material[i], wall.material, overlap, p.radius[i], p.mass[i], n, p.velocity[i], spin,
                      displacement, tangential);
    p.torque[i] += p.radius[i] * n.cross(tangential);
  }

  void touch_particle(ParticleArrays<double>& p, std::size_t i, std::size_t j, Vector3d& displacement) const {
    const Vector3d apart = p.position[j] - p.position[i];
    const double reach = p.radius[i] + p.radius[j], squared = apart.squaredNorm();
    if (!(squared < reach * reach)) {
      displacement.setZero();
      return;
    }
    const double distance = std::sqrt(squared);
    const Vector3d n = apart / distance;
    const Vector3d spin = p.radius[i] * p.angular_velocity[i] + p.radius[j] * p.angular_velocity[j];
    Vector3d tangential;
    const Vector3d force =
        law(p.material[i], p.material[j], reach - distance, p.radius[i] * p.radius[j] / reach,
            p.mass[i] * p.mass[j] / (p.mass[i] + p.mass[j]), n, p.velocity[i] - p.velocity[j], spin,
            displacement, tangential);
    const Vector3d turn = n.cross(tangential);
    p.force[i] += force;
    p.force[j] -= force;
    p.torque[i] += p.radius[i] * turn;
    p.torque[j] += p.radius[j] * turn;
  }

  // Eqs. (4)-(10).
  Vector3d law(std::uint32_t material_i, std::uint32_t material_j, double overlap, double effective_radius,
               double effective_mass, const Vector3d& n, const Vector3d& velocity, const Vector3d& spin,
               Vector3d& displacement, Vector3d& tangential) const {
    const ContactParameters& c = scene_.contacts.at(material_i, material_j);
    const double contact_radius = std::sqrt(overlap * effective_radius);
    const double k_n = c.normal_parameter * contact_radius, k_t = c.tangential_parameter * contact_radius;
    const double eta = c.damping_parameter * std::sqrt(k_n * effective_mass);
    const double normal_velocity = velocity.dot(n);
    const Vector3d tangential_velocity = velocity - normal_velocity * n + spin.cross(n);
    const double normal_force = -k_n * overlap - eta * normal_velocity;
    displacement += tangential_velocity * scene_.time_step - displacement.dot(n) * n;
    tangential = -k_t * displacement - eta * tangential_velocity;
    const double limit = c.friction_coefficient * std::abs(normal_force), length = tangential.norm();
    if (length > limit) {
      tangential *= limit / length;
      displacement = -tangential / k_t;
    }
    return normal_force * n + tangential;
  }

  const Scene& scene_;
  std::vector<Vector3d> displacement_;
};

void count_particles(benchmark::State& state, std::size_t n) {
  state.counters["particles/s"] =
      benchmark::Counter(static_cast<double>(n), benchmark::Counter::kIsIterationInvariantRate);
}

void composed_forces(benchmark::State& state) {
  Evaluation at(bed());
  const auto terms = make_force_terms<double>(bed());
  ContactForces<double> forces(bed(), at.ranges, 16);
  for (auto _ : state) forces.evaluate(terms, at.neighbours, bed().time_step, at.particles);
  count_particles(state, at.particles.id.size());
}
BENCHMARK(composed_forces)->Unit(benchmark::kMicrosecond);

void fused_forces(benchmark::State& state) {
  Evaluation composed(bed()), fused(bed());
  const auto terms = make_force_terms<double>(bed());
  ContactForces<double> reference(bed(), composed.ranges, 16);
  FusedForces forces(bed(), fused);
  reference.evaluate(terms, composed.neighbours, bed().time_step, composed.particles);
  forces.evaluate(fused);
  for (std::size_t k = 0; k < bed().particles.size(); ++k)
    if (!composed.particles.force[k].isApprox(fused.particles.force[k], 1e-9)) {
      state.SkipWithError("the fused loop computes other forces");
      return;
    }
  for (auto _ : state) {
    forces.evaluate(fused);
    benchmark::ClobberMemory();
  }
  count_particles(state, fused.particles.id.size());
}
BENCHMARK(fused_forces)->Unit(benchmark::kMicrosecond);

template <class Real>
void steps(benchmark::State& state) {
  ReferenceSolver<Real> solver(bed(), {1, 16});
  for (auto _ : state) solver.step();
  count_particles(state, bed().particles.size());
}
BENCHMARK(steps<double>)->Unit(benchmark::kMicrosecond);
BENCHMARK(steps<float>)->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace warpgrain

BENCHMARK_MAIN();
