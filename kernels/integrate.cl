// Integration: semi-implicit Euler, v += dt a(x, v), then x += dt v; the same for the angular
// velocity.

#include "place.h"
#include "prelude.h"
#include "status.h"

KERNEL void integrate(const StepParameters p, GLOBAL Place* position_radius, GLOBAL real4* velocity_mass,
                      GLOBAL real4* angular_velocity, GLOBAL const real4* force, GLOBAL const real4* torque,
                      GLOBAL uint* status) {
  const uint particle = work_item();
  if (particle == 0) count_step(status);
  if (particle >= p.n_particles) return;  // branch: beyond the last particle

  const Place place = position_radius[particle];
  const real4 velocity = velocity_mass[particle];
  const real mass = velocity.w, radius = radius_of(place);
  const real moment_of_inertia = REAL(0.4) * mass * radius * radius;

  const real3 new_velocity = xyz(velocity) + xyz(force[particle]) * (p.time_step / mass);
  const real3 new_spin =
      xyz(angular_velocity[particle]) + xyz(torque[particle]) * (p.time_step / moment_of_inertia);

  velocity_mass[particle] = make_real4(new_velocity, mass);
  position_radius[particle] = moved_place(place, new_velocity, p.time_step);
  angular_velocity[particle] = make_real4(new_spin, REAL(0.0));
}
