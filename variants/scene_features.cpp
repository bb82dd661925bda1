#include "variants/scene_features.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <tuple>

#include "variants/contact_laws.hpp"
#include "variants/models.hpp"
#include "variants/touching_pairs.hpp"

namespace warpgrain {
namespace {

constexpr std::array<std::string_view, n_features> feature_names{
    "rotation", "friction", "history",        "damping",        "repulsion", "gravity",
    "radii",    "masses",   "pair_materials", "wall_materials", "planes",    "rectangles"};

using Pairs = std::vector<ContactParameters>;

bool differ(const Pairs& pairs) {
  const auto values = [](const ContactParameters& p) {
    return std::tuple(p.normal_parameter, p.tangential_parameter, p.damping_parameter,
                      p.friction_coefficient);
  };
  return std::ranges::any_of(
      pairs, [&](const ContactParameters& pair) { return values(pair) != values(pairs.front()); });
}

bool differ(const std::vector<double>& values) {
  return std::ranges::any_of(values, [&](double value) { return value != values.front(); });
}

std::string counted(std::size_t n, std::string_view one, std::string_view many) {
  return fmt::format("{} {}", n, n == 1 ? one : many);
}

}  // namespace

class FeatureRules {
 public:
  FeatureRules(const Scene& scene, const Variant& variant)
      : scene_(scene), law_(contact_law(variant)), pairs_(scene), is_full_(model_of(variant).is_full) {
    for (std::size_t k = 0; k < n_features; ++k) features_.rows_[k].name = feature_names[k];
    if (law_.model == ContactModel::simple)
      simple_model();
    else
      practical_model();
    particles_and_walls();
  }
  SceneFeatures take() { return std::move(features_); }

 private:
  using enum FeatureId;

  void set(FeatureId feature, bool is_needed, std::string why) {
    Feature& row = features_.rows_[static_cast<std::size_t>(feature)];
    row.is_needed = is_needed;
    row.is_modelled = is_needed || is_full_;
    row.why = std::move(why);
  }
  // What the law does not have, whatever the axis says.
  void never(FeatureId feature, std::string why) {
    set(feature, false, std::move(why));
    features_.rows_[static_cast<std::size_t>(feature)].is_modelled = false;
  }

  void practical_model() {
    const bool tests_spring = scene_.model.slip_history == SlipHistory::liggghts;
    const auto rubs = [&](const ContactParameters& p) {
      const bool is_cut_to_zero = p.friction_coefficient == 0;
      return (p.tangential_parameter > 0 && !is_cut_to_zero) ||
             (p.damping_parameter > 0 && (!is_cut_to_zero || tests_spring));
    };
    const bool friction_is_needed = pairs_.any(rubs);
    set(friction, friction_is_needed,
        friction_is_needed ? "tangential forces of some pair" : "no pair has a tangential force");
    set(rotation, friction_is_needed,
        friction_is_needed ? "friction turns particles" : "without friction spins never change");
    const bool history_is_needed =
        pairs_.any([&](const ContactParameters& p) { return rubs(p) && p.tangential_parameter > 0; });
    if (law_.keeps_history)
      set(history, history_is_needed, history_is_needed ? "tangential springs" : "no tangential spring acts");
    else
      never(history, "the law keeps none");
    const bool damping_is_needed =
        pairs_.any([](const ContactParameters& p) { return p.damping_parameter > 0; });
    set(damping, damping_is_needed, damping_is_needed ? "alpha > 0 in some pair" : "alpha = 0 in every pair");
    if (scene_.model.normal_force != NormalForce::repulsive)
      never(repulsion, "normal_force is signed");
    else
      set(repulsion, damping_is_needed,
          damping_is_needed ? "damping may pull" : "without damping no force pulls");
    set(pair_materials, differ(pairs_.of_particles), rows_text(pairs_.of_particles));
    set(wall_materials, differ(pairs_.of_walls), rows_text(pairs_.of_walls));
  }

  void simple_model() {
    const SimpleParameters& simple = scene_.model.simple;
    set(friction, simple.k_shear > 0, simple.k_shear > 0 ? "k_shear > 0" : "k_shear = 0");
    set(damping, simple.k_damping > 0, simple.k_damping > 0 ? "k_damping > 0" : "k_damping = 0");
    set(rotation, false, "eq. (1) has none");
    never(history, "eq. (1) has none");
    never(repulsion, "eq. (1) has none");
    set(pair_materials, false, "eq. (1) has one set of constants");
    set(wall_materials, false, "eq. (1) has one set of constants");
  }

  void particles_and_walls() {
    const bool has_gravity = !scene_.gravity.isZero(0);
    set(gravity, has_gravity, has_gravity ? "not zero" : "zero");
    const ParticleState& particles = scene_.particles;
    set(radii, differ(particles.radius), differ(particles.radius) ? "several" : "all particles have one");
    set(masses, differ(particles.mass), differ(particles.mass) ? "several" : "all particles have one");
    const auto n_planes =
        static_cast<std::size_t>(std::ranges::count(scene_.walls, WallKind::plane, &Wall::kind));
    const std::size_t n_rectangles = scene_.walls.size() - n_planes;
    set(planes, n_planes > 0, counted(n_planes, "plane", "planes"));
    set(rectangles, n_rectangles > 0, counted(n_rectangles, "rectangle", "rectangles"));
    if (!is_full_) features_.n_walls_ = scene_.walls.size();
  }

  static std::string rows_text(const Pairs& pairs) {
    if (pairs.empty()) return "none can touch";
    return differ(pairs) ? "several sets of parameters" : "one set of parameters";
  }

  const Scene& scene_;
  const ContactLaw& law_;
  TouchingPairs pairs_;
  bool is_full_;
  SceneFeatures features_;
};

SceneFeatures features_of(const Scene& scene, const Variant& variant) {
  return FeatureRules(scene, variant).take();
}

namespace {

// As kernels/features.h names it; empty where it is there.
std::string left_out(std::string_view macro, bool is_there) {
  return is_there ? "" : fmt::format(" -D {}=0", macro);
}

}  // namespace

std::string SceneFeatures::grid_options() const {
  using enum FeatureId;
  return left_out("HAS_ROTATION", model(rotation)) + left_out("HAS_RADII", model(radii)) +
         left_out("HAS_MASSES", model(masses)) + left_out("STORES_MATERIALS", store_materials());
}

std::string SceneFeatures::pair_options() const {
  using enum FeatureId;
  return grid_options() + left_out("HAS_FRICTION", model(friction)) +
         left_out("HAS_DAMPING", model(damping)) + left_out("HAS_GRAVITY", model(gravity)) +
         left_out("HAS_MATERIALS", model(pair_materials)) + left_out("HAS_PLANES", model(planes)) +
         left_out("HAS_RECTANGLES", model(rectangles));
}

std::string SceneFeatures::wall_options() const {
  using enum FeatureId;
  return grid_options() + left_out("HAS_FRICTION", model(friction)) +
         left_out("HAS_DAMPING", model(damping)) + left_out("HAS_GRAVITY", read_motion_at_walls()) +
         left_out("HAS_MATERIALS", model(wall_materials)) + left_out("HAS_PLANES", model(planes)) +
         left_out("HAS_RECTANGLES", model(rectangles)) +
         (n_walls_ ? fmt::format(" -D N_WALLS={}", *n_walls_) : "");
}

}  // namespace warpgrain
