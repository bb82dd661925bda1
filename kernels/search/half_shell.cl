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
                                   uint n_near, GLOBAL const ulong* cell_keys,
                                   GLOBAL const Place* position_radius, GLOBAL uint* near) {
  for (uint place = stretch.x; place < stretch.y; ++place) {  // branch: next candidate
    const uint other = particle_at(place, cell_keys);
    const Pair pair = pair_with(particle->place, position_radius[other]);
    const bool is_near = touches(&pair);
    if (is_near && n_near < LIST_SLOTS) near[n_near * p.n_particles + self] = other;  // branch: near enough
    n_near += is_near ? 1 : 0;
  }
  return n_near;
}

// Forces and torques [6 * n] in quanta; contributions that large numbers of them could overflow are errors.
DEVICE_FUNCTION void add_fixed(GLOBAL long* sums, uint particle, real3 force, real3 torque,
                               const StepParameters p, uint rank, GLOBAL uint* status) {
  const real3 f = force * p.quanta_per_force, t = torque * p.quanta_per_torque;
  const real largest =
      fmax(fmax(fmax(fabs(f.x), fabs(f.y)), fmax(fabs(f.z), fabs(t.x))), fmax(fabs(t.y), fabs(t.z)));
  const real check = f.x + f.y + f.z + t.x + t.y + t.z;
  if (!is_finite(check) || !(largest < REAL(288230376151711744.0))) {  // branch: force beyond the sums
    report_error(status, is_finite(check) ? STATUS_FORCE_TOO_LARGE : STATUS_NOT_FINITE, rank);
    return;
  }
  GLOBAL long* sum = sums + 6 * particle;
  atomic_add_long(&sum[0], rounded_to_long(f.x));
  atomic_add_long(&sum[1], rounded_to_long(f.y));
  atomic_add_long(&sum[2], rounded_to_long(f.z));
  atomic_add_long(&sum[3], rounded_to_long(t.x));
  atomic_add_long(&sum[4], rounded_to_long(t.y));
  atomic_add_long(&sum[5], rounded_to_long(t.z));
}

KERNEL void clear_sums(const StepParameters p, GLOBAL long* fixed_sums, GLOBAL uint* contact_counts) {
  const uint number = work_item();
  if (number < 6 * p.n_particles) fixed_sums[number] = 0;
  if (number < 2 * p.n_particles) contact_counts[number] = 0;
}

KERNEL void force_of_pairs(const StepParameters p, GLOBAL const ulong* cell_keys,
                           GLOBAL const uint2* cell_ranges, GLOBAL uint* near,
                           GLOBAL const Place* position_radius, GLOBAL const real4* velocity_mass,
                           GLOBAL const real4* angular_velocity, GLOBAL const uint2* rank_material,
                           CONSTANT const real4* contact_parameters, GLOBAL long* fixed_sums,
                           GLOBAL uint* contact_counts, GLOBAL uint* status HISTORY_PARAMETERS) {
  const uint place = work_item();
  if (place >= p.n_particles) return;  // branch: beyond the last particle
  const uint self = particle_at(place, cell_keys);
  const Particle particle =
      load_particle(self, position_radius, velocity_mass, angular_velocity, rank_material);

  const Cell cell = cell_at(p, position_radius[self]);
  const uint2 own = cell_ranges[cell_number(p, cell.x, cell.y, cell.z)];
  uint n_near =
      list_touching(p, self, &particle, make_uint2(place + 1, own.y), 0, cell_keys, position_radius, near);
  // The 13 cells that come later: beside it along x, the row after its own, and the layer after its own.
  for (int number = 14; number < 27; ++number) {  // branch: next cell
    const int x = cell.x + number % 3 - 1, y = cell.y + number / 3 % 3 - 1, z = cell.z + number / 9 - 1;
    const bool inside = x >= 0 && x < (int)p.cells_x && y >= 0 && y < (int)p.cells_y && z < (int)p.cells_z;
    if (!inside) continue;  // branch: beyond the grid
    n_near = list_touching(p, self, &particle, cell_ranges[cell_number(p, x, y, z)], n_near, cell_keys,
                           position_radius, near);
  }
  if (n_near > LIST_SLOTS) {  // branch: list full
    report_error(status, STATUS_LIST_FULL, particle.rank);
    n_near = LIST_SLOTS;
  }

  const LawParameters law = law_parameters(p, contact_parameters);
  ForceSum sum;
  sum.force = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
  sum.torque = sum.force;
  for (uint k = 0; k < n_near; ++k) {  // branch: next contact
    const uint other = near[k * p.n_particles + self];
    const Pair pair = pair_with(particle.place, position_radius[other]);
    const Contact contact =
        contact_of(&particle, &pair, other, velocity_mass, angular_velocity, rank_material);
    const uint slot = atomic_inc(&contact_counts[2 * self]);
    const uint slot_of_other = atomic_inc(&contact_counts[2 * other]);
    (void)slot, (void)slot_of_other;  // of laws without history
    ContactHistory history = HISTORY_OF_PAIR(self, particle.rank, slot, other, slot_of_other);
    ForceSum of_contact;
    of_contact.force = make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
    of_contact.torque = of_contact.force;
    apply_contact(&law, &particle, &contact, &history, &of_contact);
    sum.force += of_contact.force;
    sum.torque += of_contact.torque;
    // eq. (3): both n and F_t are the other way round for the partner.
    const real arm = quotient(pair.radius, particle.radius);
    add_fixed(fixed_sums, other, -of_contact.force, of_contact.torque * arm, p, contact.partner, status);
  }
  add_fixed(fixed_sums, self, sum.force, sum.torque, p, particle.rank, status);
}

KERNEL void force_of_sums(const StepParameters p, GLOBAL const Place* position_radius,
                          GLOBAL const real4* velocity_mass, GLOBAL const real4* angular_velocity,
                          GLOBAL const uint2* rank_material, GLOBAL const long* fixed_sums,
                          GLOBAL real4* force, GLOBAL real4* torque) {
  const uint self = work_item();
  if (self >= p.n_particles) return;  // branch: beyond the last particle
  const Particle particle =
      load_particle(self, position_radius, velocity_mass, angular_velocity, rank_material);
  GLOBAL const long* sum = fixed_sums + 6 * self;
  const real quantum = quotient(REAL(1.0), p.quanta_per_force);
  const real quantum_of_torque = quotient(REAL(1.0), p.quanta_per_torque);
  ForceSum total = gravity_alone(p, &particle);
  total.force += make_real3((real)sum[0], (real)sum[1], (real)sum[2]) * quantum;
  force[self] = make_real4(total.force, REAL(0.0));
  torque[self] =
      make_real4(make_real3((real)sum[3], (real)sum[4], (real)sum[5]) * quantum_of_torque, REAL(0.0));
}
