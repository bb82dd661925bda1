// Integration: semi-implicit Euler, v += dt a(x, v), then x += dt v; the same for the angular
// velocity.

#include "place.h"
#include "prelude.h"
#include "status.h"

#if HAS_ROTATION
#define SPIN_PARAMETERS , GLOBAL real4 *angular_velocity, GLOBAL const real4 *torque
#else
#define SPIN_PARAMETERS
#endif

// The time step over the mass, and over the moment of inertia.
DEVICE_FUNCTION real step_per_mass(const StepParameters p, real4 velocity) {
#if HAS_MASSES
  return p.time_step / velocity.w;
#else
  (void)velocity;
  return p.step_per_mass;
#endif
}
DEVICE_FUNCTION real step_per_inertia(const StepParameters p, Place place, real4 velocity) {
#if HAS_MASSES || HAS_RADII
  return p.time_step / (REAL(0.4) * velocity.w * radius_of(place) * radius_of(place));
#else
  (void)place, (void)velocity;
  return p.step_per_inertia;
#endif
}

KERNEL void integrate(const StepParameters p, GLOBAL Place* position_radius, GLOBAL real4* velocity_mass,
                      GLOBAL const real4* force, GLOBAL uint* status SPIN_PARAMETERS) {
  const uint particle = work_item();
  if (particle == 0) count_step(status);
  if (particle >= p.n_particles) return;  // branch: beyond the last particle

  const Place place = position_radius[particle];
  const real4 velocity = velocity_mass[particle];
  const real3 new_velocity = xyz(velocity) + xyz(force[particle]) * step_per_mass(p, velocity);
#if HAS_ROTATION
  const real3 new_spin =
      xyz(angular_velocity[particle]) + xyz(torque[particle]) * step_per_inertia(p, place, velocity);
  angular_velocity[particle] = make_real4(new_spin, REAL(0.0));
#endif
  velocity_mass[particle] = make_real4(new_velocity, velocity.w);
  position_radius[particle] = moved_place(place, new_velocity, p.time_step);
}
