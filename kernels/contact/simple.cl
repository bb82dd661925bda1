// The simple model, eq. (1), of NVIDIA's "particles" sample: a linear spring along the normal, damping of the
// whole relative velocity and shear of its tangential part, constant coefficients. No rotation, no memory.

#include "contact/contact_law.h"

#if HAS_DAMPING
#define IF_DAMPED(force) (force)
#else
#define IF_DAMPED(force) NO_FORCE
#endif
#if HAS_FRICTION
#define IF_SHEARED(force) (force)
#else
#define IF_SHEARED(force) NO_FORCE
#endif

DEVICE_FUNCTION void apply_contact(const LawParameters* law, const Particle* particle, const Contact* contact,
                                   ContactHistory* history, ForceSum* sum) {
  (void)history, (void)particle;
  const real3 n = contact->contact_normal;
  const real3 relative_velocity = particle->velocity - contact->velocity;
  const real3 tangential_velocity = relative_velocity - dot(relative_velocity, n) * n;
  sum->force -= law->k_spring * contact->overlap * n + IF_DAMPED(law->k_damping * relative_velocity) +
                IF_SHEARED(law->k_shear * tangential_velocity);
}
