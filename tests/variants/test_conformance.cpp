// What every variant must satisfy on every back end, written once: one evaluation of forces, torques and
// contact history on fresh random beds against the double reference, within the bound that the law's row in
// contact_laws.cpp states.

#include <algorithm>
#include <cmath>
#include <gtest/gtest.h>
#include <map>
#include <string>

#include "core/error.hpp"
#include "core/reference_forces.hpp"
#include "core/wall.hpp"
#include "covering_variants.hpp"
#include "profiler/opencl_frontend.hpp"
#include "random_bed.hpp"
#include "variants/backend.hpp"
#include "variants/combinations.hpp"
#include "variants/device_scene.hpp"
#include "variants/kernel_compiler.hpp"
#include "variants/step_plan.hpp"

namespace warpgrain {
namespace {

struct ModelOptions {
  SlipHistory slip_history = SlipHistory::clip;
  NormalForce normal_force = NormalForce::signed_;
};
struct Case {
  const Backend* backend;
  Variant variant;
  std::vector<ModelOptions> options;
  KernelCompiler compiler = KernelCompiler::clang;
};
void PrintTo(const Case& which, std::ostream* out) {
  *out << which.backend->name << ' ' << which.variant.name();
}

std::vector<ModelOptions> every_option() {
  std::vector<ModelOptions> all;
  for (const NormalForce normal : {NormalForce::signed_, NormalForce::repulsive})
    for (const SlipHistory slip :
         {SlipHistory::clip, SlipHistory::paper, SlipHistory::lammps, SlipHistory::liggghts})
      all.push_back({slip, normal});
  return all;
}

// The host knows contact model and precision alone; the simulator runs what OpenCL devices run, slowly.
std::vector<Variant> variants_for(const Backend& backend) {
  if (backend.name == "simt") return one_value_at_a_time();
  if (backend.name != "host") return covering_variants();
  std::vector<Variant> variants;
  for (const Variant& variant : all_variants()) {
    Variant model;
    model.set("contact", variant.value(AxisId::contact));
    model.set("precision", variant.value(AxisId::precision));
    if (model == variant) variants.push_back(variant);
  }
  return variants;
}

// As CUDA C++ the kernels are the same text: what tests the words of prelude_cuda.h. Every law, search and
// precision is in one.
std::vector<Variant> variants_as_cuda() {
  std::vector<Variant> variants;
  for (const char* name : {"branchy/cells/unsorted/fp32/default", "simple/verlet/cell/fp32/native",
                           "branchless/half_shell/cell/fp64/default/sort=counting",
                           "sfu_minimised/contact_list/cell/mixed/default",
                           "branchy/two_phase/morton/fp16_history/fast_relaxed"})
    variants.push_back(Variant::parse(name));
  return variants;
}

// Each option of the model is compiled into the kernels, which takes the time of this test: the variants of a
// law share them out among themselves.
std::vector<Case> every_case() {
  std::vector<Case> cases;
  const std::vector<ModelOptions> options = every_option();
  for (const Backend& backend : backends()) {
    std::map<std::string_view, std::vector<Case>> cases_of_law;
    for (const Variant& variant : variants_for(backend))
      cases_of_law[variant.value(AxisId::contact)].push_back({&backend, variant, {}});
    for (auto& [name, of_law] : cases_of_law) {
      const std::size_t n = std::max(of_law.size(), backend.name == "simt" ? 0 : options.size());
      for (std::size_t k = 0; k < n; ++k)
        of_law[k % of_law.size()].options.push_back(options[k % options.size()]);
      cases.insert(cases.end(), of_law.begin(), of_law.end());
    }
  }
  for (const Variant& variant : variants_as_cuda())
    cases.push_back({&backend("simt"), variant, {ModelOptions{}}, KernelCompiler::cuda});
  return cases;
}

bool has_cuda_compiler() {
  try {
    compile_unit({"extern \"C\" __global__ void nothing() {}", ""}, KernelCompiler::cuda);
    return true;
  } catch (const InputError&) {
    return false;
  }
}

double largest(const std::vector<Vector3d>& vectors) {
  double norm = 0;
  for (const Vector3d& v : vectors) norm = std::max(norm, v.norm());
  return norm;
}

double largest_difference(const std::vector<Vector3d>& a, const std::vector<Vector3d>& b) {
  EXPECT_EQ(a.size(), b.size());
  double norm = 0;
  for (std::size_t k = 0; k < a.size(); ++k) {
    // Written so that a NaN is not passed over.
    const double difference = (a[k] - b[k]).norm();
    if (!(difference <= norm)) norm = difference;
  }
  return norm;
}

// What the tangential spring of each record exerts, k_t delta_t (eqs. 4 and 9): the displacement itself grows
// without bound in slipping contacts that barely touch, and so does its rounding, while their springs fade.
std::vector<Vector3d> spring_forces(const Scene& scene, const ParticleState& state,
                                    const ContactHistory& history) {
  std::map<std::uint32_t, std::size_t> index;
  for (std::size_t k = 0; k < state.size(); ++k) index[state.id[k]] = k;
  std::vector<Vector3d> forces;
  for (const ContactRecord& record : history) {
    const std::size_t i = index.at(record.particle_id);
    double overlap = 0, effective_radius = state.radius[i];
    std::uint32_t material = 0;
    if ((record.partner_id & wall_partner_bit) != 0) {
      const Wall& wall = scene.walls[record.partner_id & ~wall_partner_bit];
      overlap = state.radius[i] - wall_proximity(wall, state.position[i]).distance;
      material = wall.material;
    } else {
      const std::size_t j = index.at(record.partner_id);
      overlap = state.radius[i] + state.radius[j] - (state.position[i] - state.position[j]).norm();
      effective_radius = 1 / (1 / state.radius[i] + 1 / state.radius[j]);
      material = state.material[j];
    }
    const double stiffness = scene.contacts.at(state.material[i], material).tangential_parameter *
                             std::sqrt(std::max(overlap, 0.0) * effective_radius);
    forces.push_back(stiffness * record.tangential_displacement);
  }
  return forces;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(const ContactHistory& history) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ids;
  for (const ContactRecord& record : history) ids.emplace_back(record.particle_id, record.partner_id);
  return ids;
}

class Conformance : public testing::TestWithParam<Case> {
 protected:
  // Compares the forces at the present state, then, over a step, the history that their evaluation left.
  void expect_agreement(Scene scene) {
    const Case& c = GetParam();
    const ContactLaw& law = contact_law(c.variant);
    const double bound = error_bound(c.variant);
    BackendOptions how;
    how.compiler = c.compiler;
    const auto simulation = c.backend->create(scene, c.variant, how);
    scene.model.contact = law.model;
    const double radius = std::ranges::max(scene.particles.radius);
    const ReferenceOptions options{.threads = 1, .contact_slots = contact_slots_for(scene.particles)};
    for (int evaluation = 0; evaluation < 2; ++evaluation) {
      const ParticleState state = simulation->state();
      const ForceEvaluation expected = evaluate_forces(scene, state, scene.time_step, options);
      const ForceState forces = simulation->forces();
      const double scale = largest(expected.forces.force);
      EXPECT_LE(largest_difference(forces.force, expected.forces.force) / scale, bound);
      EXPECT_LE(largest_difference(forces.torque, expected.forces.torque) / (scale * radius), bound);
      EXPECT_EQ(simulation->contact_count(), expected.contact_count);
      simulation->step(1);
      const ContactHistory after = simulation->state().contact_history;
      ASSERT_EQ(pairs(after), pairs(expected.contact_history));
      EXPECT_LE(largest_difference(spring_forces(scene, state, after),
                                   spring_forces(scene, state, expected.contact_history)) /
                    scale,
                bound);
    }
  }
};

INSTANTIATE_TEST_SUITE_P(EveryVariant, Conformance, testing::ValuesIn(every_case()), [](const auto& c) {
  return std::string(c.param.backend->name) + '_' + test_name(c.param.variant) +
         (c.param.compiler == KernelCompiler::cuda ? "_as_cuda" : "");
});

TEST_P(Conformance, AgreesWithTheDoubleReference) {
  const Case& c = GetParam();
  if (const std::string lack = c.backend->lacks(); !lack.empty()) GTEST_SKIP() << lack;
  if (c.compiler == KernelCompiler::cuda && !has_cuda_compiler())
    GTEST_SKIP() << "neither nvcc nor NVRTC is installed";
  std::uint64_t seed = 1;
  for (const ModelOptions& options : c.options) {
    Scene bed = random_bed({.n_particles = 300 + 10 * seed, .seed = ++seed, .spacing = 1.85});
    bed.model.slip_history = options.slip_history;
    bed.model.normal_force = options.normal_force;
    SCOPED_TRACE(c.variant.name() + " on " + std::string(c.backend->name) + ", slip_history " +
                 std::string(slip_history_names[static_cast<std::size_t>(options.slip_history)]) +
                 ", normal_force " +
                 std::string(normal_force_names[static_cast<std::size_t>(options.normal_force)]) + ", seed " +
                 std::to_string(seed));
    expect_agreement(bed);
    if (contact_law(c.variant).model == ContactModel::simple) return;  // has none of these options
  }
}

// A bed that comes to rest: overlaps are thousandths of a radius and forces nearly cancel, which is where
// float has most to lose.
TEST(ConformanceAtRest, AgreesWithTheDoubleReference) {
  const Scene scene = load_scene("settled_bed", {.particles = 256, .seed = {}});
  for (const char* precision : {"fp32", "fp64", "mixed"}) {
    SCOPED_TRACE(precision);
    Variant variant;
    variant.set("precision", precision);
    const auto simulation = backend("opencl").create(scene, variant, {});
    simulation->step(6000);
    const ParticleState state = simulation->state();
    const ForceEvaluation expected = evaluate_forces(scene, state, scene.time_step);
    EXPECT_GT(expected.contact_count, 256u);
    EXPECT_EQ(simulation->contact_count(), expected.contact_count);
    EXPECT_LE(largest_difference(simulation->forces().force, expected.forces.force) /
                  largest(expected.forces.force),
              error_bound_at_rest(variant));
  }
}

}  // namespace
}  // namespace warpgrain
