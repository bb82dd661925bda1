#pragma once
// One force evaluation of the reference: finds who touches, forms the contacts in batches, lets the force
// terms act on them, and sums per particle in a fixed order: body forces last, contacts in ascending order of
// (i, partner).

#include <cstddef>
#include <cstdint>
#include <vector>

#include "core/contact_batch.hpp"
#include "core/force_term.hpp"
#include "core/neighbour_list.hpp"
#include "core/scene.hpp"

namespace warpgrain {

// The particles as the solver holds them, in ascending order of id. All [n_particles].
template <class Real>
struct ParticleArrays {
  std::vector<std::uint32_t> id, material;
  std::vector<Real> radius, mass;
  std::vector<Vector3<Real>> position, velocity, angular_velocity, force, torque;
};

template <class Real>
class ContactForces {
 public:
  ContactForces(const Scene& scene, const std::vector<IndexRange>& ranges, std::size_t contact_slots);

  // History of the contacts at the next evaluation, indices being those of particles sorted by id.
  void set_history(const ContactHistory& history, const ParticleArrays<Real>& particles);
  // Fills particles.force and .torque. `candidates` must be complete for the positions. Throws
  // SimulationError naming the particle when it has more contacts than slots, lies on another's centre, or
  // its force is not a number.
  void evaluate(const ForceTermList<Real>& terms, const NeighbourList<Real>& candidates, Real time_step,
                ParticleArrays<Real>& particles);

  std::uint64_t contact_count() const;
  // As it stood before, and as it stands after the last evaluation.
  ContactHistory history_before(const ParticleArrays<Real>& particles) const {
    return listed(before_, particles);
  }
  ContactHistory history_after(const ParticleArrays<Real>& particles) const {
    return listed(after_, particles);
  }

 private:
  struct TouchingRows {  // as PartnerRows, of those that touch
    PartnerRows rows;
    std::vector<Vector3<Real>> tangential_displacement;
  };
  struct Workspace {  // of one range
    ContactBatch<Real> batch;
    std::vector<Vector3<Real>> force, turn;  // F and n x F_t of each contact, as rows.partner
  };

  void evaluate_range(std::size_t range, const ForceTermList<Real>& terms,
                      const NeighbourList<Real>& candidates, Real time_step,
                      const ParticleArrays<Real>& particles);
  // Appends the contact to the batch, without its history, when the two touch.
  bool gather_if_touching(std::size_t i, std::uint32_t partner, const ParticleArrays<Real>& particles,
                          ContactBatch<Real>& batch) const;
  void add_up(ParticleArrays<Real>& particles);
  void add_body_forces(const IndexRange& range, const ForceTermList<Real>& terms,
                       ParticleArrays<Real>& particles);
  ContactHistory listed(const std::vector<TouchingRows>& touching,
                        const ParticleArrays<Real>& particles) const;

  std::vector<Wall> walls_;
  ContactTable parameters_;
  std::vector<IndexRange> ranges_;
  std::size_t contact_slots_;
  bool keeps_history_ = true;
  std::vector<TouchingRows> before_, after_;  // [n_ranges]
  std::vector<Workspace> work_;               // [n_ranges]
  std::vector<std::uint32_t> contacts_of_;    // [n_particles]
};

}  // namespace warpgrain
