#include "core/scene_json.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>

#include "core/error.hpp"

namespace warpgrain {
namespace {

std::vector<std::string_view> material_names(const Scene& scene) {
  std::vector<std::string_view> names;
  for (const Material& material : scene.materials) names.push_back(material.name);
  return names;
}

ContactParameters read_contact(const JsonReader& json, const Material& a, const Material& b) {
  json.require_keys({"between", "restitution", "friction", "normal_parameter", "tangential_parameter",
                     "damping_parameter"});
  ContactParameters parameters;
  parameters.friction_coefficient = json.at("friction").number_at_least(0);
  const auto normal = json.maybe("normal_parameter"), tangential = json.maybe("tangential_parameter");
  const auto damping = json.maybe("damping_parameter"), restitution = json.maybe("restitution");
  parameters.normal_parameter = normal ? normal->number_above(0) : 4.0 / 3.0 * effective_youngs_modulus(a, b);
  parameters.tangential_parameter =
      tangential ? tangential->number_at_least(0) : 8 * effective_shear_modulus(a, b);
  if (damping && restitution) damping->fail("stands beside 'restitution'", "one of the two");
  if (!damping && !restitution) json.fail("neither 'restitution' nor 'damping_parameter'", "one of the two");
  if (damping) {
    parameters.damping_parameter = damping->number_at_least(0);
  } else {
    const double e = restitution->number();
    if (!(e > 0 && e <= 1)) restitution->fail(fmt::format("{}", e), "a number above 0, at most 1");
    parameters.damping_parameter = damping_parameter_of_restitution(e);
  }
  return parameters;
}

// Every pair that may touch must have its parameters; they cannot be guessed.
void require_pairs(const JsonReader& json, const Scene& scene, const std::vector<bool>& given) {
  const std::size_t n = scene.materials.size();
  std::vector<std::size_t> particles(n, 0);
  for (std::uint32_t material : scene.particles.material) ++particles[material];
  const auto require = [&](std::size_t a, std::size_t b) {
    if (!given[a * n + b])
      json.fail(
          fmt::format("nothing between '{}' and '{}'", scene.materials[a].name, scene.materials[b].name),
          "an entry for every pair of materials that may touch");
  };
  for (std::size_t a = 0; a < n; ++a)
    for (std::size_t b = a; b < n; ++b)
      if (particles[a] > 0 && particles[b] > (a == b ? 1 : 0)) require(a, b);
  for (const Wall& wall : scene.walls)
    for (std::size_t a = 0; a < n; ++a)
      if (particles[a] > 0) require(a, wall.material);
}

RunEnd read_end(const JsonReader& json) {
  json.require_keys({"steps", "time", "at_rest"});
  RunEnd end;
  if (const auto steps = json.maybe("steps")) end.steps = steps->count();
  if (const auto time = json.maybe("time")) end.time = time->number_above(0);
  if (const auto at_rest = json.maybe("at_rest")) {
    at_rest->require_keys({"displacement", "window"});
    end.at_rest = RunEnd::AtRest{at_rest->at("displacement").number_above(0), at_rest->at("window").count()};
  }
  if (int{end.steps.has_value()} + int{end.time.has_value()} + int{end.at_rest.has_value()} != 1)
    json.fail("not one end", "exactly one of 'steps', 'time', 'at_rest'");
  return end;
}

}  // namespace

std::uint32_t material_index(const JsonReader& name, const Scene& scene) {
  return static_cast<std::uint32_t>(name.one_of(material_names(scene), "material"));
}

void read_model(const JsonReader& scene_json, Scene& scene) {
  const auto json = scene_json.maybe("model");
  if (!json) return;
  json->require_keys({"contact", "slip_history", "normal_force", "simple"});
  ModelOptions& model = scene.model;
  if (const auto v = json->maybe("contact"))
    model.contact = static_cast<ContactModel>(v->one_of(contact_model_names, "contact model"));
  if (const auto v = json->maybe("slip_history"))
    model.slip_history = static_cast<SlipHistory>(v->one_of(slip_history_names, "slip history"));
  if (const auto v = json->maybe("normal_force"))
    model.normal_force = static_cast<NormalForce>(v->one_of(normal_force_names, "normal force"));
  if (const auto v = json->maybe("simple")) {
    v->require_keys({"k_spring", "k_damping", "k_shear"});
    model.simple.k_spring = v->at("k_spring").number_above(0);
    model.simple.k_damping = v->at("k_damping").number_at_least(0);
    model.simple.k_shear = v->at("k_shear").number_at_least(0);
  }
}

SimpleParameters default_simple_parameters(const Scene& scene, const ContactParameters& first_contact) {
  const auto& radii = scene.particles.radius;
  const auto smallest =
      static_cast<std::size_t>(std::min_element(radii.begin(), radii.end()) - radii.begin());
  const double radius = radii[smallest], overlap = 0.01 * radius;
  SimpleParameters simple;
  simple.k_spring = first_contact.normal_parameter * std::sqrt(overlap * radius / 2);
  simple.k_damping =
      first_contact.damping_parameter * std::sqrt(simple.k_spring * scene.particles.mass[smallest] / 2);
  simple.k_shear = 5 * simple.k_damping;
  return simple;
}

void read_materials(const JsonReader& scene_json, Scene& scene) {
  const JsonReader json = scene_json.at("materials");
  for (const JsonReader& entry : json.elements()) {
    entry.require_keys({"name", "density", "youngs_modulus", "poisson_ratio"});
    Material material;
    material.name = entry.at("name").string();
    for (const Material& other : scene.materials)
      if (other.name == material.name) entry.at("name").fail("'" + material.name + "' twice", "unique names");
    material.density = entry.at("density").number_above(0);
    material.youngs_modulus = entry.at("youngs_modulus").number_above(0);
    material.poisson_ratio = entry.at("poisson_ratio").number();
    if (!(material.poisson_ratio > -1 && material.poisson_ratio <= 0.5))
      entry.at("poisson_ratio")
          .fail(fmt::format("{}", material.poisson_ratio), "a number above -1, at most 0.5");
    scene.materials.push_back(material);
  }
  if (scene.materials.empty()) json.fail("empty", "at least one material");
}

void read_contacts(const JsonReader& scene_json, Scene& scene) {
  const JsonReader json = scene_json.at("contacts");
  const std::size_t n = scene.materials.size();
  scene.contacts = ContactTable(n);
  std::vector<bool> given(n * n, false);
  std::optional<ContactParameters> first;
  for (const JsonReader& entry : json.elements()) {
    const auto names = entry.at("between").elements(2, "two names of materials");
    const std::uint32_t a = material_index(names[0], scene), b = material_index(names[1], scene);
    if (given[a * n + b]) entry.at("between").fail("a pair given before", "each pair once");
    given[a * n + b] = given[b * n + a] = true;
    scene.contacts.set(a, b, read_contact(entry, scene.materials[a], scene.materials[b]));
    if (!first) first = scene.contacts.at(a, b);
  }
  require_pairs(json, scene, given);
  if (scene.model.simple.k_spring > 0) return;
  if (!first) json.fail("empty", "at least one entry, or model.simple");
  scene.model.simple = default_simple_parameters(scene, *first);
}

void read_domain(const JsonReader& scene_json, Scene& scene) {
  const auto json = scene_json.maybe("domain");
  if (!json) return;
  json->require_keys({"lower", "upper"});
  scene.domain = {json->at("lower").vector(), json->at("upper").vector()};
  if (!((scene.domain.upper - scene.domain.lower).minCoeff() > 0))
    json->fail("no volume", "every coordinate of 'upper' above that of 'lower'");
}

void read_time(const JsonReader& scene_json, Scene& scene) {
  const JsonReader json = scene_json.at("time");
  json.require_keys({"step", "end"});
  const JsonReader step = json.at("step");
  if (step.is_string()) {
    if (step.string() != "auto") step.fail("'" + step.string() + "'", "seconds, or \"auto\"");
    scene.time_step_is_auto = true;
  } else {
    scene.time_step = step.number_above(0);
  }
  scene.end = read_end(json.at("end"));
}

}  // namespace warpgrain
