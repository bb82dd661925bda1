#include "core/simple_model.hpp"

namespace warpgrain {
namespace {

// F = -k_spring overlap n
template <class Real>
class SimpleSpring final : public ForceTerm<Real> {
 public:
  explicit SimpleSpring(double k_spring) : k_spring_(static_cast<Real>(k_spring)) {}
  std::string_view name() const override { return "simple_spring"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.normal_force -= k_spring_ * c.overlap;
  }

 private:
  Real k_spring_;
};

// F = -k_damping v
template <class Real>
class SimpleDamping final : public ForceTerm<Real> {
 public:
  explicit SimpleDamping(double k_damping) : k_damping_(static_cast<Real>(k_damping)) {}
  std::string_view name() const override { return "simple_damping"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.central_force -= k_damping_ * c.relative_velocity;
  }

 private:
  Real k_damping_;
};

// F = -k_shear (v - (v.n) n)
template <class Real>
class SimpleShear final : public ForceTerm<Real> {
 public:
  explicit SimpleShear(double k_shear) : k_shear_(static_cast<Real>(k_shear)) {}
  std::string_view name() const override { return "simple_shear"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.central_force -= k_shear_ * c.centre_tangential_velocity;
  }

 private:
  Real k_shear_;
};

}  // namespace

template <class Real>
void add_simple_model(ForceTermList<Real>& terms, const SimpleParameters& parameters) {
  terms.add(std::make_unique<SimpleSpring<Real>>(parameters.k_spring));
  terms.add(std::make_unique<SimpleDamping<Real>>(parameters.k_damping));
  terms.add(std::make_unique<SimpleShear<Real>>(parameters.k_shear));
}

template void add_simple_model(ForceTermList<float>&, const SimpleParameters&);
template void add_simple_model(ForceTermList<double>&, const SimpleParameters&);

}  // namespace warpgrain
