#pragma once
// The one interface of everything that exerts a force. A solver's physics is a list of terms; a term is added
// with `add`, taken out with `remove`, at run time, and no other code changes:
//
//   auto terms = make_force_terms<double>(scene);
//   terms.remove("normal_damping");
//   terms.add(std::make_unique<MyCohesion>());
//   ReferenceSolver<double> solver(scene, std::move(terms));

#include <cstddef>
#include <memory>
#include <string_view>
#include <vector>

#include "core/contact_batch.hpp"
#include "core/scene.hpp"

namespace warpgrain {

// Terms are applied in this order, within a stage in the order of their adding: a limit sees all that it
// limits.
enum class ForceStage { coefficients, force, normal_limit, tangential_limit };

template <class Real>
class ForceTerm {
 public:
  virtual ~ForceTerm() = default;
  virtual std::string_view name() const = 0;  // unique in a list
  virtual ForceStage stage() const { return ForceStage::force; }
  // Whether tangential_displacement must be kept from step to step.
  virtual bool keeps_history() const { return false; }
  // Both are called concurrently from several threads, on different batches.
  virtual void apply_to_contacts(ContactBatch<Real>&, Real /*time_step*/) const {}
  virtual void apply_to_bodies(BodyBatch<Real>&) const {}
};

template <class Real>
class ForceTermList {
 public:
  // Throws InputError when a term of that name is there.
  void add(std::unique_ptr<ForceTerm<Real>> term);
  // Throws InputError that lists the terms there are.
  void remove(std::string_view name);
  std::vector<std::string_view> names() const;  // in the order of application
  bool keeps_history() const;

  void apply(ContactBatch<Real>& batch, Real time_step) const {
    for (const auto& term : terms_) term->apply_to_contacts(batch, time_step);
  }
  void apply(BodyBatch<Real>& batch) const {
    for (const auto& term : terms_) term->apply_to_bodies(batch);
  }

 private:
  std::vector<std::unique_ptr<ForceTerm<Real>>> terms_;  // sorted by stage
};

// The terms of the scene's model, gravity included: eq. (1) or eqs. (2)-(10) with its options.
template <class Real>
ForceTermList<Real> make_force_terms(const Scene& scene);

}  // namespace warpgrain
