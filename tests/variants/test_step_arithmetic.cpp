#include <cmath>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <numbers>
#include <random>

#include "core/time_step_advice.hpp"
#include "variants/backend.hpp"
#include "variants/contact_laws.hpp"
#include "variants/step_arithmetic.hpp"

namespace warpgrain {
namespace {

using testing::HasSubstr;

struct Impact {
  double radius = 1e-3, youngs_modulus = 1e7, restitution = 0.8, speed = 1;
  double place = 0;  // m from the origin
};

Scene scene_of(const Impact& impact) {
  const double r = impact.radius, x = impact.place;
  return parse_scene(
      fmt::format(R"({{ "format": "warpgrain.scene/1",
    "materials": [ {{ "name": "m", "density": 2500, "youngs_modulus": {}, "poisson_ratio": 0.3 }} ],
    "contacts": [ {{ "between": ["m", "m"], "restitution": {}, "friction": 0.5 }} ],
    "particles": [ {{ "material": "m", "radius": {}, "position": [{}, 0, 0], "velocity": [{}, 0, 0] }},
                   {{ "material": "m", "radius": {}, "position": [{}, 0, 0], "velocity": [{}, 0, 0] }} ],
    "domain": {{ "lower": [{}, {}, {}], "upper": [{}, {}, {}] }},
    "time": {{ "step": "auto", "end": {{ "steps": 1 }} }} }})",
                  impact.youngs_modulus, impact.restitution, r, x - 1.001 * r, impact.speed / 2, r,
                  x + 1.001 * r, -impact.speed / 2, x - 50 * r, -50 * r, -50 * r, x + 50 * r, 50 * r, 50 * r),
      "impact");
}

TimeStepAdvice advice_for(Scene& scene, const Variant& variant) {
  scene.model.contact = contact_law(variant).model;
  const TimeStepAdvice advice =
      advise_time_step(scene, time_step_limits(scene), step_arithmetic(scene, variant));
  scene.time_step = advice.step;
  return advice;
}

double restitution_seen(const Scene& scene, const Variant& variant, const Backend& where, double speed) {
  BackendOptions options;
  options.threads = 1;
  const auto simulation = where.create(scene, variant, options);
  const double reach = scene.particles.radius[0] + scene.particles.radius[1];
  for (int k = 0; k < 400; ++k) {
    simulation->step(20);
    const ParticleState state = simulation->state();
    const double parting = state.velocity[1].x() - state.velocity[0].x();
    if (parting > 0 && (state.position[1] - state.position[0]).norm() > reach) return parting / speed;
  }
  return 0;
}

double restitution_of_simple(const Scene& scene) {
  const double z = scene.model.simple.k_damping /
                   (2 * std::sqrt(scene.model.simple.k_spring * scene.particles.mass[0] / 2));
  return std::exp(-std::numbers::pi * z / std::sqrt(1 - z * z));
}

// What the advice promises, in random scenes and the variants that the host knows.
TEST(StepArithmetic, AdviceKeepsRestitutionWithinOnePercent) {
  constexpr unsigned seed = 7;
  std::mt19937 random(seed);
  const auto between = [&](double from, double to) {
    return from + (to - from) * static_cast<double>(random()) / static_cast<double>(std::mt19937::max());
  };
  int right = 0, refused = 0;
  for (int k = 0; k < 60; ++k) {
    const Impact impact{std::pow(10, between(-4, -2)), std::pow(10, between(6, 9)), between(0.2, 1),
                        std::pow(10, between(-1.5, 0.7)), std::pow(10, between(-2, 1))};
    Variant variant;
    if (k % 3 == 0) variant.set("contact", "simple");
    if (k % 2 == 0) variant.set("precision", "fp64");
    Scene scene = scene_of(impact);
    const TimeStepAdvice advice = advice_for(scene, variant);
    if (!advice.is_right) {
      EXPECT_EQ(variant.value(AxisId::precision), "fp32") << advice.reason;
      EXPECT_THAT(advice.reason, HasSubstr("places in fp32 are"));
      ++refused;
      continue;
    }
    const double expected = k % 3 == 0 ? restitution_of_simple(scene) : impact.restitution;
    EXPECT_NEAR(restitution_seen(scene, variant, backend("host"), impact.speed), expected,
                0.011 * std::max(expected, 0.1))
        << "seed " << seed << ", scene " << k << ", " << variant.name() << ": " << advice.reason;
    ++right;
  }
  EXPECT_GT(right, 30);
  EXPECT_GT(refused, 3);
}

TEST(StepArithmetic, FixedPlacesAreRightWhereFloatsAreNot) {
  const Impact far{1e-3, 1e8, 0.8, 0.5, 20};
  Scene scene = scene_of(far);
  EXPECT_FALSE(advice_for(scene, Variant()).is_right);
  if (!backend("opencl").lacks().empty()) GTEST_SKIP() << backend("opencl").lacks();
  const Variant mixed = Variant::parse("branchy/cells/cell/mixed/default");
  EXPECT_TRUE(advice_for(scene, mixed).is_right);
  EXPECT_NEAR(restitution_seen(scene, mixed, backend("opencl"), far.speed), 0.8, 0.011 * 0.8);
}

TEST(StepArithmetic, LawsHaveStepsOfTheirOwn) {
  const Impact damped{1e-3, 1e7, 0.3, 1, 0};
  Scene practical = scene_of(damped), simple = scene_of(damped);
  EXPECT_LE(advice_for(practical, Variant()).restitution_error, 0.01);
  const TimeStepAdvice advice = advice_for(simple, Variant::parse("simple/cells/cell/fp64/default"));
  EXPECT_LE(advice.restitution_error, 0.01);
  EXPECT_THAT(advice.reason, HasSubstr("would put a restitution of"));
  EXPECT_NE(simple.time_step, practical.time_step);
}

}  // namespace
}  // namespace warpgrain
