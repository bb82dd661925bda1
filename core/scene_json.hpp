#pragma once
// The parts of a scene file, each read into the scene by one function; all throw InputError naming the place.

#include "core/json_reader.hpp"
#include "core/scene.hpp"

namespace warpgrain {

void read_model(const JsonReader& scene_json, Scene& scene);
void read_materials(const JsonReader& scene_json, Scene& scene);
void read_contacts(const JsonReader& scene_json, Scene& scene);
void read_walls(const JsonReader& scene_json, Scene& scene);
void read_domain(const JsonReader& scene_json, Scene& scene);  // nothing where there is none
void read_time(const JsonReader& scene_json, Scene& scene);    // time_step stays 0 for "auto"

// Reads the particles, after the materials. Returns by how much `overrides` stretches the scene's lengths: 1,
// or the cube root of the ratio of particle numbers.
double read_particles(const JsonReader& scene_json, const SceneOverrides& overrides, Scene& scene);

std::uint32_t material_index(const JsonReader& name, const Scene& scene);

// Coefficients of eq. (1) for a scene that gives none, so that every scene runs under the simple model. For
// two of the smallest particles with the parameters of the first contact: k_spring and k_damping are k_n and
// eta of eqs. (8), (10) at an overlap of 1 % of the radius; k_shear is 5 k_damping, the ratio in NVIDIA's
// sample.
SimpleParameters default_simple_parameters(const Scene& scene, const ContactParameters& first_contact);

}  // namespace warpgrain
