#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "core/force_term.hpp"
#include "core/reference_solver.hpp"
#include "tests/core/example_scenes.hpp"

namespace warpgrain {
namespace {

using testing::ElementsAre;

// What a user would write: two touching bodies attract each other in proportion to the contact's area.
template <class Real>
class LinearCohesion final : public ForceTerm<Real> {
 public:
  explicit LinearCohesion(Real strength) : strength_(strength) {}
  std::string_view name() const override { return "linear_cohesion"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.normal_force += strength_ * c.overlap * c.effective_radius;
  }

 private:
  Real strength_;
};

class Drag final : public ForceTerm<double> {
 public:
  std::string_view name() const override { return "drag"; }
  void apply_to_bodies(BodyBatch<double>& bodies) const override {
    for (std::size_t k = 0; k < bodies.force.size(); ++k)
      bodies.force[k] -= 3 * bodies.mass[k] * bodies.velocity[k];
  }
};

TEST(ForceTerm, ListOfAScenesModel) {
  Scene scene = head_on_impact(1, R"("restitution": 0.8, "friction": 0.5)").scene();
  EXPECT_THAT(make_force_terms<double>(scene).names(),
              ElementsAre("hertz_mindlin", "normal_spring", "normal_damping", "tangential_spring",
                          "tangential_damping", "gravity", "coulomb_limit"));
  scene.model.contact = ContactModel::simple;
  EXPECT_THAT(make_force_terms<float>(scene).names(),
              ElementsAre("simple_spring", "simple_damping", "simple_shear", "gravity"));
}

TEST(ForceTerm, LimitsSeeTermsAddedLater) {
  Scene scene = head_on_impact(1, R"("restitution": 0.8, "friction": 0.5)").scene();
  scene.model.normal_force = NormalForce::repulsive;
  auto terms = make_force_terms<double>(scene);
  terms.add(std::make_unique<LinearCohesion<double>>(1.0));
  EXPECT_THAT(terms.names(), ElementsAre("hertz_mindlin", "normal_spring", "normal_damping",
                                         "tangential_spring", "tangential_damping", "gravity",
                                         "linear_cohesion", "repulsive_limit", "coulomb_limit"));
}

TEST(ForceTerm, RemovedDampingMakesAnImpactElastic) {
  const Scene scene = head_on_impact(2, R"("restitution": 0.5, "friction": 0.5)").scene();
  auto terms = make_force_terms<double>(scene);
  terms.remove("normal_damping");
  ReferenceSolver<double> solver(scene, std::move(terms));
  solver.step(3000);
  EXPECT_EQ(solver.contact_count(), 0u);
  EXPECT_NEAR(solver.state().velocity[1].x(), 1, 1e-3);
}

TEST(ForceTerm, RemovedTangentialSpringKeepsNoHistory) {
  const Scene scene = head_on_impact(2, R"("restitution": 0.5, "friction": 0.5)").scene();
  auto terms = make_force_terms<double>(scene);
  EXPECT_TRUE(terms.keeps_history());
  terms.remove("tangential_spring");
  EXPECT_FALSE(terms.keeps_history());
  ReferenceSolver<double> solver(scene, std::move(terms));
  solver.step(700);
  EXPECT_EQ(solver.contact_count(), 1u);
  EXPECT_TRUE(solver.contact_history().empty());
}

TEST(ForceTerm, AddedCohesionHoldsAnImpactBack) {
  // Without its attraction the contact would end after some 1300 steps.
  const Scene scene = head_on_impact(0.2, R"("restitution": 0.5, "friction": 0)").scene();
  ReferenceSolver<double> plain(scene);
  auto terms = make_force_terms<double>(scene);
  terms.add(std::make_unique<LinearCohesion<double>>(3e6));
  ReferenceSolver<double> cohesive(scene, std::move(terms));
  plain.step(20000);
  cohesive.step(20000);
  EXPECT_EQ(plain.contact_count(), 0u);
  EXPECT_EQ(cohesive.contact_count(), 1u);
}

TEST(ForceTerm, AddedAndRemovedWhileRunning) {
  const Scene scene = head_on_impact(1, R"("restitution": 1, "friction": 0)").scene();
  ReferenceSolver<double> solver(scene);
  solver.terms().add(std::make_unique<Drag>());
  solver.step(2);  // the first step still moves by the old forces
  const double slower = 0.5 * (1 - 3 * scene.time_step);
  EXPECT_DOUBLE_EQ(solver.state().velocity[0].x(), slower);
  solver.terms().remove("drag");
  solver.step(1);
  const double slowest = solver.state().velocity[0].x();
  EXPECT_LT(slowest, slower);
  solver.step(10);
  EXPECT_EQ(solver.state().velocity[0].x(), slowest);
}

TEST(ForceTerm, RefusesUnknownAndDoubleNames) {
  const Scene scene = head_on_impact(1, R"("restitution": 1, "friction": 0)").scene();
  auto terms = make_force_terms<double>(scene);
  EXPECT_THAT([&] { terms.remove("damping"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("valid: hertz_mindlin, normal_spring")));
  terms.add(std::make_unique<Drag>());
  EXPECT_THAT([&] { terms.add(std::make_unique<Drag>()); },
              testing::ThrowsMessage<InputError>("force terms: two terms named 'drag'"));
}

}  // namespace
}  // namespace warpgrain
