// What a contact law is to the kernels around it. A law is one .cl file beside this one that defines
// apply_contact(); the kernels that find contacts (search/*.cl, force_from_walls.cl) call it for every
// touching partner and know no law. What a law does not read costs nothing: all of it is inlined.
//
// A law may #define, before it includes this file:
//   ONE_ROOT_A_PAIR   distance and contact normal come from one reciprocal square root (overlap.h)
#ifndef WARPGRAIN_CONTACT_LAW_H
#define WARPGRAIN_CONTACT_LAW_H

#include "contact_history.h"
#include "place.h"
#include "prelude.h"

// The particle whose work-item runs.
typedef struct {
  Place place;
  real3 velocity;
#if HAS_ROTATION
  real3 angular_velocity;
#endif
  real radius, mass;
  real inverse_radius, inverse_mass;
  uint rank, material;
} Particle;

// A partner that touches it. A wall has infinite radius and mass and rests: both inverses and all motion are
// zero. R* = radius / radius_ratio and m* = mass / mass_ratio say the same without a division: against
// another particle j these are r_j and (r_i + r_j) / r_i, against a wall r_i and 1.
typedef struct {
  real3 contact_normal;    // unit, from the particle to the partner
  real overlap;            // > 0
  real3 velocity;          // of the partner's centre
  real3 surface_rotation;  // radius times angular velocity of the partner
  real inverse_radius, inverse_mass;
  real radius, radius_ratio, mass, mass_ratio;
  uint partner;  // rank, or WALL_PARTNER_BIT | index of the wall
  uint material;
} Contact;

// What a law may look up.
typedef struct {
#if HAS_MATERIALS
  CONSTANT const real4* contact_parameters;  // [n_materials * n_materials]: C_kn, C_kt, alpha, mu
  uint n_materials;
#endif
  ContactConstants constants;
  real time_step;
  real k_spring, k_damping, k_shear;
} LawParameters;

typedef struct {
  real3 force;
#if HAS_ROTATION
  real3 torque;
#endif
} ForceSum;

// Vanishes from sums at compile time: x + -0.0 is x.
#define NO_FORCE make_real3(REAL(-0.0), REAL(-0.0), REAL(-0.0))

// A parameter of kernels that apply the law, and how they gather what it may look up; `constants` is the
// member of StepParameters for their contacts.
#if HAS_MATERIALS
#define MATERIAL_PARAMETER , CONSTANT const real4* contact_parameters
#define LAW_PARAMETERS(p, constants) law_parameters(p, p.constants, contact_parameters)
#else
#define MATERIAL_PARAMETER
#define LAW_PARAMETERS(p, constants) law_parameters(p, p.constants)
#endif

DEVICE_FUNCTION LawParameters law_parameters(const StepParameters p,
                                             const ContactConstants constants MATERIAL_PARAMETER) {
  LawParameters law;
#if HAS_MATERIALS
  law.contact_parameters = contact_parameters;
  law.n_materials = p.n_materials;
#endif
  law.constants = constants;
  law.time_step = p.time_step;
  law.k_spring = p.k_spring;
  law.k_damping = p.k_damping;
  law.k_shear = p.k_shear;
  return law;
}

// C_kn, C_kt, alpha, mu of the contact.
DEVICE_FUNCTION real4 parameters_of(const LawParameters* law, const Particle* particle,
                                    const Contact* contact) {
#if HAS_MATERIALS
  return law->contact_parameters[particle->material * law->n_materials + contact->material];
#else
  const ContactConstants c = law->constants;
  return make_real4(make_real3(c.normal_parameter, c.tangential_parameter, c.damping_parameter),
                    c.friction_coefficient);
#endif
}

// R* and m*, and what they are made of in laws that divide later. Where all particles are alike the host has
// computed them, as the kernels would.
#if HAS_RADII
#define effective_radius_of(law, particle, contact) \
  quotient(REAL(1.0), (particle)->inverse_radius + (contact)->inverse_radius)
#define radius_ratio_of(law, contact) ((contact)->radius_ratio)
#else
#define effective_radius_of(law, particle, contact) ((law)->constants.effective_radius)
#define radius_ratio_of(law, contact) ((law)->constants.radius_ratio)
#endif
#if HAS_MASSES
#define effective_mass_of(law, particle, contact) \
  quotient(REAL(1.0), (particle)->inverse_mass + (contact)->inverse_mass)
#define mass_ratio_of(law, contact) ((contact)->mass_ratio)
#else
#define effective_mass_of(law, particle, contact) ((law)->constants.effective_mass)
#define mass_ratio_of(law, contact) ((law)->constants.mass_ratio)
#endif

// Adds to `sum` the force and torque on the particle; a law with history reads and continues the contact's
// slot.
DEVICE_FUNCTION void apply_contact(const LawParameters* law, const Particle* particle, const Contact* contact,
                                   ContactHistory* history, ForceSum* sum);

#endif
