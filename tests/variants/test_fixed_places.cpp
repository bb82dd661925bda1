// Precision `mixed`: what its fixed-point places are for, and that nothing is lost on the way to a device.

#include <Eigen/Geometry>
#include <cmath>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <limits>
#include <numeric>

#include "core/error.hpp"
#include "core/reference_forces.hpp"
#include "random_bed.hpp"
#include "variants/backend.hpp"
#include "variants/contact_laws.hpp"
#include "variants/device_scene.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

std::unique_ptr<Simulation> simulation_in(const Scene& scene, const std::string& precision,
                                          const std::string& backend_name = "opencl",
                                          const std::string& law_and_search = "branchy/cells/cell/") {
  return backend(backend_name).create(scene, Variant::parse(law_and_search + precision + "/default"), {});
}

Scene moved(Scene scene, const Vector3d& way) {
  for (Vector3d& position : scene.particles.position) position += way;
  for (Wall& wall : scene.walls) wall.point += way;
  scene.domain.lower += way;
  scene.domain.upper += way;
  return scene;
}

constexpr double radius = 1e-3, mass = 1.05e-5, normal_parameter = 7.3e10;

// Spheres of 1 mm and E = 1e11 Pa, without gravity.
Scene stiff_spheres(const std::vector<Vector3d>& positions) {
  Scene scene;
  scene.materials = {{"glass", 2500, 1e11, 0.3}};
  scene.contacts = ContactTable(1);
  scene.contacts.set(0, 0, {normal_parameter, 8e10, 0.5, 0.5});
  scene.time_step = 1e-7;
  scene.end.steps = 1;
  for (std::uint32_t k = 0; k < positions.size(); ++k) {
    scene.particles.id.push_back(k);
    scene.particles.material.push_back(0);
    scene.particles.radius.push_back(radius);
    scene.particles.mass.push_back(mass);
    scene.particles.position.push_back(positions[k]);
    scene.particles.velocity.push_back(Vector3d::Zero());
    scene.particles.angular_velocity.push_back(Vector3d::Zero());
  }
  scene.domain = {Vector3d::Constant(-0.02), Vector3d::Constant(0.02)};
  return scene;
}

double hertz_force(double overlap, double effective_radius) {
  return normal_parameter * std::sqrt(effective_radius) * std::pow(overlap, 1.5);
}

struct Touching {
  const char* what;
  Scene scene;
};

// A static overlap of 1.6 nm with another sphere and with each kind of wall.
std::vector<Touching> touching_by_16_angstrom() {
  constexpr double overlap = 1.6e-9;
  const Vector3d z = Vector3d::UnitZ(), way = Vector3d(1, -2, 0.5).normalized(), zero = Vector3d::Zero();
  std::vector<Touching> all{{"sphere", stiff_spheres({zero, way * (2 * radius - overlap)})}};
  const auto with_wall = [&](const char* what, WallKind kind, const Vector3d& normal, const Vector3d& point,
                             const Vector3d& u, const Vector3d& v) {
    all.push_back({what, stiff_spheres({zero})});
    all.back().scene.walls = {{kind, 0, point, normal, u, v}};
  };
  const Vector3d below = -(radius - overlap) * z, u = Vector3d(0.1, 0, 0), v = Vector3d(0, 0.2, 0);
  with_wall("plane", WallKind::plane, z, below, zero, zero);
  const Vector3d aside = z.cross(way) * 0.01;  // the plane's point is not the nearest
  with_wall("tilted plane", WallKind::plane, -way, way * (radius - overlap) + aside, zero, zero);
  with_wall("rectangle", WallKind::rectangle, z, below - 0.3 * u - 0.7 * v, u, v);
  // An edge, beside which the sphere lies, above the rectangle's plane.
  const Vector3d to_edge = Vector3d(0.6, 0, -0.8) * (radius - overlap);
  with_wall("edge", WallKind::rectangle, z, to_edge - 0.4 * v, u, v);
  return all;
}

double off_by(const Touching& touching, double distance, const char* precision, const char* backend_name) {
  const Vector3d far(distance, -0.7 * distance, 0.3 * distance);
  const Scene scene = moved(touching.scene, far);
  const bool is_pair = scene.particles.size() == 2;
  const double force = simulation_in(scene, precision, backend_name)->forces().force[0].norm();
  return std::abs(force / hertz_force(1.6e-9, is_pair ? radius / 2 : radius) - 1);
}

TEST(FixedPlaces, AnOverlapOf16AngstromIsTheSameFarFromTheOrigin) {
  for (const Touching& touching : touching_by_16_angstrom()) {
    SCOPED_TRACE(touching.what);
    for (const double distance : {0.0, 1.0, 100.0}) {
      const double mixed = off_by(touching, distance, "mixed", "opencl"),
                   fp32 = off_by(touching, distance, "fp32", "opencl");
      // Doubles at 100 m are 1.4e-14 m apart, a part in 10^5 of the overlap.
      EXPECT_LE(mixed, distance < 100 ? 2e-6 : 5e-5);
      if (distance > 0) {
        EXPECT_GE(fp32, 0.01);
      }
    }
  }
}

TEST(FixedPlaces, TheSimulatorResolvesThemToo) {
  if (const std::string lack = backend("simt").lacks(); !lack.empty()) GTEST_SKIP() << lack;
  for (const Touching& touching : touching_by_16_angstrom())
    EXPECT_LE(off_by(touching, 100, "mixed", "simt"), 5e-5) << touching.what;
}

// A sphere that is laid on a plane sinks in until the plane carries it, and stays there.
TEST(FixedPlaces, ASphereComesToRestWhereItsWeightIsCarried) {
  for (const double distance : {0.0, 100.0}) {
    Scene scene = stiff_spheres({Vector3d(0, 0, radius)});
    scene.gravity = {0, 0, -9.81};
    scene.walls = {{WallKind::plane, 0, Vector3d::Zero(), Vector3d::UnitZ(), {}, {}}};
    scene = moved(scene, {distance, 0.3 * distance, -0.7 * distance});
    const double floor = scene.walls[0].point.z();
    const auto simulation = simulation_in(scene, "mixed");
    simulation->step(4000);
    const double overlap = radius - (simulation->state().position[0].z() - floor);
    const double expected = std::pow(mass * 9.81 / hertz_force(1, radius), 2.0 / 3);
    EXPECT_NEAR(overlap / expected, 1, 1e-4) << distance;
  }
}

double largest_difference_of(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  double largest = 0, difference = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    largest = std::max(largest, b[k].norm());
    difference = std::max(difference, (a[k] - b[k]).norm());
  }
  return difference / largest;
}

// Of the forces on the places as the scene gives them.
double error_of_bed(double distance, const std::string& precision, const std::string& law_and_search) {
  const Scene bed = moved(random_bed({.n_particles = 600, .seed = 12}), Vector3d::Constant(distance));
  const ForceEvaluation expected =
      evaluate_forces(bed, bed.particles, bed.time_step, {.contact_slots = contact_slots_for(bed.particles)});
  const auto simulation = simulation_in(bed, precision, "opencl", law_and_search);
  const ParticleState state = simulation->state();
  std::vector<Vector3d> forces(bed.particles.size());
  const ForceState of_device = simulation->forces();
  for (std::size_t k = 0; k < state.size(); ++k)
    forces[static_cast<std::size_t>(std::ranges::find(bed.particles.id, state.id[k]) -
                                    bed.particles.id.begin())] = of_device.force[k];
  return largest_difference_of(forces, expected.forces.force);
}

TEST(FixedPlaces, ABedIsAsGoodFarFromTheOrigin) {
  for (const char* law_and_search : {"branchy/cells/cell/", "sfu_minimised/verlet/unsorted/"}) {
    SCOPED_TRACE(law_and_search);
    const double near = error_of_bed(0, "mixed", law_and_search),
                 far = error_of_bed(100, "mixed", law_and_search);
    const double fp32 = error_of_bed(100, "fp32", law_and_search);
    EXPECT_LE(near, 1e-6);
    EXPECT_LE(far, 1e-6);
    EXPECT_GE(fp32, 5e-4);
  }
}

TEST(FixedPlaces, MomentumIsConservedFarFromTheOrigin) {
  Scene bed = moved(random_bed({.n_particles = 1000, .seed = 14}), Vector3d::Constant(100));
  bed.gravity.setZero();
  bed.walls.clear();
  bed.particles.contact_history.clear();
  const auto momentum = [](const ParticleState& state) {
    Vector3d sum = Vector3d::Zero();
    for (std::size_t k = 0; k < state.size(); ++k) sum += state.mass[k] * state.velocity[k];
    return sum;
  };
  const auto simulation = simulation_in(bed, "mixed");
  const ParticleState before = simulation->state();
  double exchanged = 0;
  for (const Vector3d& force : simulation->forces().force) exchanged += force.norm() * bed.time_step;
  simulation->step(20);
  const double change = (momentum(simulation->state()) - momentum(before)).norm();
  EXPECT_LE(change, 1e-6 * 20 * exchanged);
}

// Places and radii go to a device to the unit, and what comes back goes there as it is.
TEST(FixedPlaces, StatesAreHandedOnExactly) {
  Scene bed = moved(random_bed({.n_particles = 500, .seed = 3}), {100, -3, 0.01});
  std::iota(bed.particles.id.begin(), bed.particles.id.end(), 0u);
  bed.particles.contact_history.clear();
  for (const char* law_and_search : {"branchy/cells/cell/", "branchy/verlet/unsorted/"}) {
    SCOPED_TRACE(law_and_search);
    const auto whole = simulation_in(bed, "mixed", "opencl", law_and_search);
    const ParticleState given = whole->state();
    for (std::size_t k = 0; k < given.size(); ++k) {
      EXPECT_EQ(given.position[k].x(), bed.particles.position[k].x());
      EXPECT_LE((given.position[k] - bed.particles.position[k]).norm(), 1e-16);
      EXPECT_NEAR(given.radius[k], bed.particles.radius[k], 1e-16);
    }
    whole->step(7);
    Scene half = bed;
    half.particles = whole->state();
    const auto continued = simulation_in(half, "mixed", "opencl", law_and_search);
    EXPECT_EQ(continued->state().position, half.particles.position);
    EXPECT_EQ(continued->state().velocity, half.particles.velocity);
    // What a double at 100 m leaves of a place is 1.4e-14 m.
    EXPECT_LE(largest_difference_of(continued->forces().force, whole->forces().force), 1e-6);
  }
}

std::string message_from(const Scene& scene) {
  try {
    simulation_in(scene, "mixed")->step(100);
  } catch (const std::exception& e) {
    return e.what();
  }
  return "no error";
}

TEST(FixedPlaces, WhatIsNoPlaceIsSaid) {
  Scene scene = stiff_spheres({Vector3d::Zero()});
  scene.particles.position[0].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THAT(message_from(scene), HasSubstr("step 0: particle 0 has a position or a force that is not"));
  scene.particles.position[0] = {0, 1e30, 0};
  EXPECT_EQ(message_from(scene), "step 0: particle 0 left the domain");
  scene.particles.position[0].setZero();
  scene.particles.velocity[0] = {0, 0, -1e15};
  EXPECT_EQ(message_from(scene), "step 1: particle 0 left the domain");
  scene.particles.velocity[0] = {0, 0, std::numeric_limits<double>::infinity()};
  EXPECT_THAT(message_from(scene), HasSubstr("step 1: particle 0 has a position or a force that is not"));
}

TEST(FixedPlaces, AScenePastTheirRangeIsRefused) {
  Scene scene = stiff_spheres({Vector3d::Zero()});
  scene.particles.radius = {1e-11};
  EXPECT_THAT(message_from(scene), HasSubstr("states in double are no finer than floats there"));
}

}  // namespace
}  // namespace warpgrain
