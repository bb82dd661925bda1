// The contact slots of a particle: what each touching partner's contact remembers, keyed by the partner's
// rank. The slots of the evaluation before are read, those of this one are written, so that contacts that
// ended fall away by themselves.
#ifndef WARPGRAIN_CONTACT_HISTORY_H
#define WARPGRAIN_CONTACT_HISTORY_H

#include "prelude.h"
#include "status.h"

// Slots of a particle; 0: no history is kept, and the arrays are not there.
#ifndef CONTACT_SLOTS
#define CONTACT_SLOTS 16
#endif

// Tangential displacements as they are stored: real, or (-D HALF_HISTORY, precision `fp16_history`) half, in
// HISTORY_UNIT [m], a power of two, so that 2^-14 to 65504 of it are stored to 11 bits.
#ifdef HALF_HISTORY
#ifndef HISTORY_UNIT
#define HISTORY_UNIT 0x1p-24f
#endif
typedef half StoredReal;

DEVICE_FUNCTION real3 load_displacement(uint slot, GLOBAL const StoredReal* displacements) {
  return make_real3(vload_half(3 * slot, displacements), vload_half(3 * slot + 1, displacements),
                    vload_half(3 * slot + 2, displacements)) *
         HISTORY_UNIT;
}
DEVICE_FUNCTION void store_displacement(real3 displacement, uint slot, GLOBAL StoredReal* displacements) {
  const real3 scaled = displacement * (REAL(1.0) / HISTORY_UNIT);
  vstore_half(scaled.x, 3 * slot, displacements);
  vstore_half(scaled.y, 3 * slot + 1, displacements);
  vstore_half(scaled.z, 3 * slot + 2, displacements);
}
// Written so that a NaN is not.
DEVICE_FUNCTION bool is_storable(real3 displacement) {
  const real largest = fmax(fmax(fabs(displacement.x), fabs(displacement.y)), fabs(displacement.z));
  return largest <= REAL(65504.0) * HISTORY_UNIT;
}
#else
typedef real StoredReal;

DEVICE_FUNCTION real3 load_displacement(uint slot, GLOBAL const StoredReal* displacements) {
  return vload3(slot, displacements);
}
DEVICE_FUNCTION void store_displacement(real3 displacement, uint slot, GLOBAL StoredReal* displacements) {
  vstore3(displacement, slot, displacements);
}
#endif

#if CONTACT_SLOTS > 0
// Parameters of the kernels that evaluate forces, and how they are gathered into a ContactHistory.
#define HISTORY_PARAMETERS                                                        \
  , GLOBAL const uint2 *counts_before, GLOBAL const uint *partners_before,        \
      GLOBAL const StoredReal *displacements_before, GLOBAL uint *partners_after, \
      GLOBAL StoredReal *displacements_after

// Of the slots, not of the contacts: a particle that ran out of slots goes on until the host has looked.
DEVICE_FUNCTION uint used_slots(uint2 counts) { return min(counts.x + counts.y, (uint)CONTACT_SLOTS); }

typedef struct {
  GLOBAL const uint* partners_before;
  GLOBAL const StoredReal* displacements_before;
  uint n_before;
  GLOBAL uint* partners_after;
  GLOBAL StoredReal* displacements_after;
  uint n_after;
  GLOBAL uint* status;
  uint rank;
#ifdef EACH_PAIR_ONCE
  // Where the partner keeps the same contact.
  GLOBAL uint* partners_of_other;
  GLOBAL StoredReal* displacements_of_other;
  uint n_of_other;
#endif
} ContactHistory;

#define HISTORY_OF(particle, rank, n_after)                                                         \
  history_of(particle, rank, n_after, status, counts_before, partners_before, displacements_before, \
             partners_after, displacements_after)

DEVICE_FUNCTION ContactHistory history_of(uint particle, uint rank, uint n_after,
                                          GLOBAL uint* status HISTORY_PARAMETERS) {
  ContactHistory history;
  history.partners_before = partners_before + particle * CONTACT_SLOTS;
  history.displacements_before = displacements_before + particle * CONTACT_SLOTS * 3;
  history.n_before = used_slots(counts_before[particle]);
  history.partners_after = partners_after + particle * CONTACT_SLOTS;
  history.displacements_after = displacements_after + particle * CONTACT_SLOTS * 3;
  history.n_after = n_after;
  history.status = status;
  history.rank = rank;
  return history;
}

// The tangential displacement that the contact with `partner` remembers; zero for a new contact.
DEVICE_FUNCTION real3 remembered_displacement(const ContactHistory* history, uint partner) {
  for (uint slot = 0; slot < history->n_before; ++slot) {  // branch: history search
    if (history->partners_before[slot] == partner) {       // branch: history found
      return load_displacement(slot, history->displacements_before);
    }
  }
  return make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
}

// The same for laws without branches: all slots are looked at, and one is loaded.
DEVICE_FUNCTION real3 remembered_displacement_without_branches(const ContactHistory* history, uint partner) {
  uint found = 0;
  bool is_known = false;
  for (uint slot = 0; slot < history->n_before; ++slot) {  // branch: used contact slots
    const bool is_it = history->partners_before[slot] == partner;
    found = is_it ? slot : found;
    is_known |= is_it;
  }
  const real3 displacement = load_displacement(found, history->displacements_before);
  return make_real3(is_known ? displacement.x : REAL(0.0), is_known ? displacement.y : REAL(0.0),
                    is_known ? displacement.z : REAL(0.0));
}

DEVICE_FUNCTION void remember_displacement(ContactHistory* history, uint partner, real3 displacement) {
  if (history->n_after >= CONTACT_SLOTS) {  // branch: slots full
    report_error(history->status, STATUS_SLOTS_FULL, history->rank);
    return;
  }
#ifdef HALF_HISTORY
  if (!is_storable(displacement))  // branch: displacement too large
    report_error(history->status, STATUS_DISPLACEMENT_TOO_LARGE, history->rank);
#endif
#ifdef EACH_PAIR_ONCE
  if (history->n_of_other >= CONTACT_SLOTS) {  // branch: slots of partner full
    report_error(history->status, STATUS_SLOTS_FULL, partner);
    return;
  }
  history->partners_of_other[history->n_of_other] = history->rank;
  store_displacement(-displacement, history->n_of_other, history->displacements_of_other);
#endif
  history->partners_after[history->n_after] = partner;
  store_displacement(displacement, history->n_after, history->displacements_after);
  history->n_after += 1;
}

#ifdef EACH_PAIR_ONCE
// For searches that see each pair once: what is remembered is remembered on both sides, each with its sign.
#define HISTORY_OF_PAIR(particle, rank, slot, other, slot_of_other)                        \
  history_of_pair(history_of(particle, rank, slot, status, counts_before, partners_before, \
                             displacements_before, partners_after, displacements_after),   \
                  other, slot_of_other, partners_after, displacements_after)

DEVICE_FUNCTION ContactHistory history_of_pair(ContactHistory history, uint other, uint slot_of_other,
                                               GLOBAL uint* partners_after,
                                               GLOBAL StoredReal* displacements_after) {
  history.partners_of_other = partners_after + other * CONTACT_SLOTS;
  history.displacements_of_other = displacements_after + other * CONTACT_SLOTS * 3;
  history.n_of_other = slot_of_other;
  return history;
}
#endif
#else
#define HISTORY_PARAMETERS
#define HISTORY_OF(particle, rank, n_after) 0
#define HISTORY_OF_PAIR(particle, rank, slot, other, slot_of_other) 0
typedef int ContactHistory;

DEVICE_FUNCTION real3 remembered_displacement(const ContactHistory* history, uint partner) {
  (void)history, (void)partner;
  return make_real3(REAL(0.0), REAL(0.0), REAL(0.0));
}
#define remembered_displacement_without_branches remembered_displacement
DEVICE_FUNCTION void remember_displacement(ContactHistory* history, uint partner, real3 displacement) {
  (void)history, (void)partner, (void)displacement;
}
#endif

#endif
