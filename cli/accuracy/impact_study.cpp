#include "cli/accuracy/impact_study.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <functional>
#include <numbers>

#include "analysis/impact_theory.hpp"
#include "cli/accuracy/single_impact.hpp"
#include "core/error.hpp"

namespace warpgrain::cli {
namespace {

using Table = reports::StudyReport::Table;
using Value = reports::StudyReport::Value;

// Where only what an impact leaves counts; a contact has some 400 steps.
constexpr std::uint64_t after_only = 40;
constexpr double degree = std::numbers::pi / 180;

// Who is held against theory.
struct Contender {
  std::string name;
  std::function<SingleImpact(const Scene&, std::uint64_t look_every)> impact;
};

std::vector<Contender> contenders(const std::vector<AccuracyCase>& cases, const BackendOptions& options) {
  Variant reference;
  reference.set("precision", "fp64");
  std::vector<Contender> all{{"double reference", [=](const Scene& scene, std::uint64_t look_every) {
                                return single_impact(scene, backend("host"), reference, options, look_every);
                              }}};
  for (const AccuracyCase& which : cases)
    all.push_back({which.name(), [=](const Scene& scene, std::uint64_t look_every) {
                     return single_impact(with_step(scene, which.step_factor), which.runs_on(), which.variant,
                                          options, look_every);
                   }});
  return all;
}

HertzImpact theory_of(const Scene& scene) {
  const ParticleState& p = scene.particles;
  if (!scene.walls.empty())
    return hertz_impact(scene.contacts.at(0, scene.walls[0].material).normal_parameter, p.radius[0],
                        p.mass[0], p.velocity[0].norm());
  return hertz_impact(scene.contacts.at(0, 0).normal_parameter, p.radius[0] / 2, p.mass[0] / 2,
                      (p.velocity[0] - p.velocity[1]).norm());
}

// A scene of tests 1 and 2, looked at in every step.
struct ElasticImpact {
  std::string name;
  Scene scene;
  HertzImpact theory;
  std::vector<SingleImpact> seen;  // [contenders]
};

ElasticImpact elastic_impact(std::string_view name, const std::vector<Contender>& all) {
  ElasticImpact impact{std::string(name), load_scene(name), {}, {}};
  impact.theory = theory_of(impact.scene);
  for (const Contender& contender : all) impact.seen.push_back(contender.impact(impact.scene, 1));
  return impact;
}

// Tests 1 and 2: without damping, against Hertz.
Table elastic_table(std::string title, const std::vector<ElasticImpact>& impacts,
                    const std::vector<Contender>& all) {
  Table table{std::move(title),
              "",
              {"scene", "by", "largest overlap [um]", "largest force [kN]", "duration [us]", "restitution"},
              {}};
  for (const ElasticImpact& impact : impacts) {
    const HertzImpact& theory = impact.theory;
    const double stiffness = theory.largest_force / std::pow(theory.largest_overlap, 1.5);
    table.rows.push_back({impact.name, std::string("Hertz"), 1e6 * theory.largest_overlap,
                          1e-3 * theory.largest_force, 1e6 * theory.duration, 1.0});
    for (std::size_t k = 0; k < all.size(); ++k) {
      const SingleImpact& seen = impact.seen[k];
      table.rows.push_back({impact.name, all[k].name, 1e6 * seen.largest_overlap,
                            1e-3 * stiffness * std::pow(seen.largest_overlap, 1.5), 1e6 * seen.duration,
                            seen.after.velocity[0].norm() / impact.scene.particles.velocity[0].norm()});
    }
  }
  return table;
}

// The force while the contact lasts.
Table force_table(int test, const ElasticImpact& impact, const std::vector<Contender>& all) {
  Table table{fmt::format("Test {}: normal force [kN] over time, {}", test, impact.name),
              "",
              {"time [us]", "Hertz"},
              {}};
  for (const Contender& contender : all) table.columns.push_back(contender.name);
  constexpr int rows = 12;
  for (int k = 0; k <= rows; ++k) {
    const double time = impact.theory.duration * k / rows;
    std::vector<Value> row{1e6 * time, 1e-3 * hertz_force(impact.theory, time)};
    for (const SingleImpact& seen : impact.seen) row.emplace_back(1e-3 * force_at(seen, time));
    table.rows.push_back(row);
  }
  return table;
}

// Test 3: the restitution that comes out for the one put in.
Table restitution_table(const std::vector<Contender>& all) {
  Table table{"Test 3: restitution of a sphere and a wall", "", {"scene", "restitution set"}, {}};
  for (const Contender& contender : all) table.columns.push_back(contender.name);
  for (std::string_view name : {"impact_3_alumina", "impact_3_cast_iron"})
    for (double restitution : {0.2, 0.4, 0.6, 0.8, 1.0}) {
      Scene scene = load_scene(name);
      ContactParameters contact = scene.contacts.at(0, 1);
      contact.damping_parameter = damping_parameter_of_restitution(restitution);
      scene.contacts.set(0, 1, contact);
      std::vector<Value> row{std::string(name), restitution};
      for (const Contender& contender : all)
        row.emplace_back(contender.impact(scene, after_only).after.velocity[0].z() /
                         -scene.particles.velocity[0].z());
      table.rows.push_back(row);
    }
  return table;
}

// Test 4: what an oblique impact leaves, beside the closed form for impacts that slip throughout.
Table oblique_table(std::string_view name, const std::vector<Contender>& all) {
  Table table{
      fmt::format("Test 4: oblique impact, {}", name),
      "Tangential restitution is v_x after over before, both of the centre; spin is w_y, at the angle "
      "from the normal. Theory: friction takes mu (1 + e) v_n from v_x, and w = 5 mu (1 + e) v_n / (2 r), "
      "where the contact slips to its end: tan(angle) above 7/2 mu (1 + e).",
      {"angle [degrees]", "by", "tangential restitution", "rebound angle [degrees]", "spin [rad/s]"},
      {}};
  for (double angle : {5, 10, 15, 20, 25, 30, 40, 50, 60, 70, 80, 85}) {
    Scene scene = load_scene(name);
    set_angle(scene, angle);
    const Vector3d before = scene.particles.velocity[0];
    const double restitution = 0.98;
    const SlidingImpact theory = sliding_impact(-before.z(), before.x(), scene.particles.radius[0],
                                                restitution, scene.contacts.at(0, 1).friction_coefficient);
    const auto rebound = [](double tangential, double normal) {
      return std::atan2(tangential, normal) / degree;
    };
    if (theory.slips_throughout)
      table.rows.push_back({angle, std::string("theory"), theory.tangential_velocity / before.x(),
                            rebound(theory.tangential_velocity, -restitution * before.z()),
                            theory.angular_velocity});
    for (const Contender& contender : all) {
      const ParticleState after = contender.impact(scene, after_only).after;
      table.rows.push_back({angle, contender.name, after.velocity[0].x() / before.x(),
                            rebound(after.velocity[0].x(), after.velocity[0].z()),
                            after.angular_velocity[0].y()});
    }
  }
  return table;
}

}  // namespace

std::vector<Table> impact_tables(const std::vector<AccuracyCase>& cases, const BackendOptions& options) {
  const std::vector<Contender> all = contenders(cases, options);
  const std::vector<ElasticImpact> first{elastic_impact("impact_1_glass", all),
                                         elastic_impact("impact_1_limestone", all)},
      second{elastic_impact("impact_2_aluminium", all), elastic_impact("impact_2_magnesium", all)};
  return {elastic_table("Test 1: two spheres, without damping", first, all),
          elastic_table("Test 2: a sphere and a rigid wall, without damping", second, all),
          force_table(1, first[0], all),
          force_table(1, first[1], all),
          force_table(2, second[0], all),
          force_table(2, second[1], all),
          restitution_table(all),
          oblique_table("impact_4_alumina", all),
          oblique_table("impact_4_aluminium", all)};
}

}  // namespace warpgrain::cli
