// The forces between particles with Newton's third law: a work-item looks at its own cell and at half of the
// cells around it, so that each pair is found once, and its force goes to both. What comes from several
// work-items is added up in integers, whose sums do not depend on the order: fixed point, in quanta that
// device_scene.cpp chooses from the scene.

// The law's files need to know, too: the step plan defines it for both.
#ifndef EACH_PAIR_ONCE
#define EACH_PAIR_ONCE
#endif
#include "contact/contact_law.h"
#include "pair.h"
#include "particle_access.h"
#include "prelude.h"
#include "search/candidates.h"

// Appends the touching partners of a stretch to the list of `self`.
DEVICE_FUNCTION uint list_touching(const StepParameters p, uint self, const Particle* particle, uint2 stretch,
                                   uint n_near MAP_PARAMETER, GLOBAL const Place* position_radius,
                                   GLOBAL uint* near) {
  for (uint place = stretch.x; place < stretch.y; ++place) {  // branch: next candidate
    const uint other = particle_at(place MAP_ARGUMENT);
    const Pair pair = pair_with(particle->place, position_radius[other]);
    const bool is_near = touches(&pair);
    if (is_near && n_near < LIST_SLOTS) near[n_near * p.n_particles + self] = other;  // branch: near enough
    n_near += is_near ? 1 : 0;
  }
  return n_near;
}

// Forces and torques [SUM_REALS * n] in quanta; contributions that large numbers of them could overflow are
// errors.
DEVICE_FUNCTION void add_fixed(GLOBAL long* sums, uint particle, const ForceSum* added,
                               const StepParameters p, uint rank, GLOBAL uint* status) {
  const real3 f = added->force * p.quanta_per_force;
  real largest = fmax(fmax(fabs(f.x), fabs(f.y)), fabs(f.z));
  real check = f.x + f.y + f.z;
#if HAS_ROTATION
  const real3 t = added->torque * p.quanta_per_torque;
  largest = fmax(fmax(largest, fabs(t.x)), fmax(fabs(t.y), fabs(t.z)));
  check = check + t.x + t.y + t.z;
#endif
  if (!is_finite(check) || !(largest < REAL(288230376151711744.0))) {  // branch: force beyond the sums
    report_error(status, is_finite(check) ? STATUS_FORCE_TOO_LARGE : STATUS_NOT_FINITE, rank);
    return;
  }
  GLOBAL long* sum = sums + SUM_REALS * particle;
  atomic_add_long(&sum[0], rounded_to_long(f.x));
  atomic_add_long(&sum[1], rounded_to_long(f.y));
  atomic_add_long(&sum[2], rounded_to_long(f.z));
#if HAS_ROTATION
  atomic_add_long(&sum[3], rounded_to_long(t.x));
  atomic_add_long(&sum[4], rounded_to_long(t.y));
  atomic_add_long(&sum[5], rounded_to_long(t.z));
#endif
}

DEVICE_FUNCTION real3 quanta_of(GLOBAL const long* sum) {
  return make_real3((real)sum[0], (real)sum[1], (real)sum[2]);
}

KERNEL void clear_sums(const StepParameters p, GLOBAL long* fixed_sums, GLOBAL uint* contact_counts) {
  const uint number = work_item();
  if (number < SUM_REALS * p.n_particles) fixed_sums[number] = 0;
  if (number < 2 * p.n_particles) contact_counts[number] = 0;
}

KERNEL void force_of_pairs(const StepParameters p MAP_PARAMETER, GLOBAL const uint2* cell_ranges,
                           GLOBAL uint* near, PARTICLE_PARAMETERS MATERIAL_PARAMETER, GLOBAL long* fixed_sums,
                           GLOBAL uint* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const uint self = particle_at(place MAP_ARGUMENT);
  const Particles particles = PARTICLES;
  const Particle particle = load_particle(p, self, &particles);

  const Cell cell = cell_at(p, position_radius[self]);
  const uint2 own = cell_ranges[cell_number(p, cell.x, cell.y, cell.z)];
  uint n_near =
      list_touching(p, self, &particle, make_uint2(place + 1, own.y), 0 MAP_ARGUMENT, position_radius, near);
  // The 13 cells that come later: beside it along x, the row after its own, and the layer after its own.
  for (int number = 14; number < 27; ++number) {  // branch: next cell
    const int x = cell.x + number % 3 - 1, y = cell.y + number / 3 % 3 - 1, z = cell.z + number / 9 - 1;
    const bool inside = x >= 0 && x < (int)p.cells_x && y >= 0 && y < (int)p.cells_y && z < (int)p.cells_z;
    if (!inside) continue;  // branch: beyond the grid
    n_near = list_touching(p, self, &particle, cell_ranges[cell_number(p, x, y, z)], n_near MAP_ARGUMENT,
                           position_radius, near);
  }
  if (n_near > LIST_SLOTS) {  // branch: list full
    report_error(status, STATUS_LIST_FULL, particle.rank);
    n_near = LIST_SLOTS;
  }

  const LawParameters law = LAW_PARAMETERS(p, of_pairs);
  ForceSum sum = no_sum();
  for (uint k = 0; k < n_near; ++k) {  // branch: next contact
    const uint other = near[k * p.n_particles + self];
    const Pair pair = pair_with(particle.place, position_radius[other]);
    const Contact contact = contact_of(&particle, &pair, other, &particles);
    const uint slot = atomic_inc(&contact_counts[2 * self]);
    const uint slot_of_other = atomic_inc(&contact_counts[2 * other]);
    (void)slot, (void)slot_of_other;  // of laws without history
    ContactHistory history = HISTORY_OF_PAIR(self, particle.rank, slot, other, slot_of_other);
    ForceSum of_contact = no_sum();
    apply_contact(&law, &particle, &contact, &history, &of_contact);
    add_to_sum(&sum, &of_contact);
    // eq. (3): both n and F_t are the other way round for the partner.
    ForceSum of_other;
    of_other.force = -of_contact.force;
#if HAS_ROTATION
    of_other.torque = of_contact.torque * (HAS_RADII ? quotient(pair.radius, particle.radius) : REAL(1.0));
#endif
    add_fixed(fixed_sums, other, &of_other, p, contact.partner, status);
  }
  add_fixed(fixed_sums, self, &sum, p, particle.rank, status);
}

// The weight of particles of several masses is all that depends on a particle here.
#if HAS_GRAVITY && HAS_MASSES
#define MASS_PARAMETER , GLOBAL const real4* velocity_mass
#define MASS_OF(particle) velocity_mass[particle].w
#else
#define MASS_PARAMETER
#define MASS_OF(particle) p.mass
#endif

KERNEL void force_of_sums(const StepParameters p MASS_PARAMETER, GLOBAL const long* fixed_sums,
                          SUM_PARAMETERS) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Sums sums = SUMS;
  GLOBAL const long* sum = fixed_sums + SUM_REALS * self;
  ForceSum total = gravity_alone(p, MASS_OF(self));
  total.force += quanta_of(sum) * quotient(REAL(1.0), p.quanta_per_force);
#if HAS_ROTATION
  total.torque = quanta_of(sum + 3) * quotient(REAL(1.0), p.quanta_per_torque);
#endif
  store_forces(self, &total, &sums);
}
