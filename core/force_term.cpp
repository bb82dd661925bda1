#include "core/force_term.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/practical_model.hpp"
#include "core/simple_model.hpp"

namespace warpgrain {
namespace {

// A body's weight.
template <class Real>
class Gravity final : public ForceTerm<Real> {
 public:
  explicit Gravity(const Vector3d& acceleration) : acceleration_(acceleration.cast<Real>()) {}
  std::string_view name() const override { return "gravity"; }
  void apply_to_bodies(BodyBatch<Real>& bodies) const override {
    for (std::size_t k = 0; k < bodies.force.size(); ++k) bodies.force[k] += acceleration_ * bodies.mass[k];
  }

 private:
  Vector3<Real> acceleration_;
};

}  // namespace

template <class Real>
void ForceTermList<Real>::add(std::unique_ptr<ForceTerm<Real>> term) {
  for (std::string_view name : names())
    if (name == term->name()) throw_input_error("force terms", "two terms named '" + std::string(name) + "'");
  const auto later = [](ForceStage stage, const auto& other) { return stage < other->stage(); };
  terms_.insert(std::upper_bound(terms_.begin(), terms_.end(), term->stage(), later), std::move(term));
}

template <class Real>
void ForceTermList<Real>::remove(std::string_view name) {
  const auto found =
      std::find_if(terms_.begin(), terms_.end(), [&](const auto& t) { return t->name() == name; });
  if (found == terms_.end()) throw_unknown_name("force terms", "term", name, names());
  terms_.erase(found);
}

template <class Real>
std::vector<std::string_view> ForceTermList<Real>::names() const {
  std::vector<std::string_view> result;
  for (const auto& term : terms_) result.push_back(term->name());
  return result;
}

template <class Real>
bool ForceTermList<Real>::keeps_history() const {
  return std::any_of(terms_.begin(), terms_.end(), [](const auto& t) { return t->keeps_history(); });
}

template <class Real>
ForceTermList<Real> make_force_terms(const Scene& scene) {
  ForceTermList<Real> terms;
  if (scene.model.contact == ContactModel::simple)
    add_simple_model(terms, scene.model.simple);
  else
    add_practical_model(terms, scene.model);
  terms.add(std::make_unique<Gravity<Real>>(scene.gravity));
  return terms;
}

template class ForceTermList<float>;
template class ForceTermList<double>;
template ForceTermList<float> make_force_terms(const Scene&);
template ForceTermList<double> make_force_terms(const Scene&);

}  // namespace warpgrain
