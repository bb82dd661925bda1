#include "core/practical_model.hpp"

namespace warpgrain {
namespace {

template <class Real>
class HertzMindlin final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "hertz_mindlin"; }
  ForceStage stage() const override { return ForceStage::coefficients; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    // sqrt(overlap R*), the radius of the contact circle, is shared by eqs. (8) and (9).
    c.normal_stiffness = (c.overlap * c.effective_radius).sqrt();
    c.tangential_stiffness = c.tangential_parameter * c.normal_stiffness;
    c.normal_stiffness *= c.normal_parameter;
    c.damping_coefficient = c.damping_parameter * (c.normal_stiffness * c.effective_mass).sqrt();
  }
};

template <class Real>
class NormalSpring final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "normal_spring"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.normal_force -= c.normal_stiffness * c.overlap;
  }
};

template <class Real>
class NormalDamping final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "normal_damping"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.normal_force -= c.damping_coefficient * c.normal_velocity;
  }
};

template <class Real>
class TangentialSpring final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "tangential_spring"; }
  bool keeps_history() const override { return true; }
  void apply_to_contacts(ContactBatch<Real>& c, Real time_step) const override {
    const typename ContactBatch<Real>::Scalars out_of_plane =
        row_dot(c.tangential_displacement, c.contact_normal);
    c.tangential_displacement +=
        c.tangential_velocity * time_step - c.contact_normal.colwise() * out_of_plane;
    c.tangential_force -= c.tangential_displacement.colwise() * c.tangential_stiffness;
  }
};

template <class Real>
class TangentialDamping final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "tangential_damping"; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.tangential_force -= c.tangential_velocity.colwise() * c.damping_coefficient;
  }
};

template <class Real>
class RepulsiveLimit final : public ForceTerm<Real> {
 public:
  std::string_view name() const override { return "repulsive_limit"; }
  ForceStage stage() const override { return ForceStage::normal_limit; }
  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    c.normal_force = c.normal_force.min(Real(0));
  }
};

template <class Real>
class CoulombLimit final : public ForceTerm<Real> {
 public:
  explicit CoulombLimit(SlipHistory slip_history) : slip_history_(slip_history) {}
  std::string_view name() const override { return "coulomb_limit"; }
  ForceStage stage() const override { return ForceStage::tangential_limit; }

  void apply_to_contacts(ContactBatch<Real>& c, Real) const override {
    // What eq. (5) tests and cuts: all of F_t, but under `liggghts` the spring alone.
    Vectors spring;
    const bool tests_spring = slip_history_ == SlipHistory::liggghts;
    if (tests_spring) spring = c.tangential_displacement.colwise() * -c.tangential_stiffness;
    const Vectors& tested = tests_spring ? spring : c.tangential_force;

    const Scalars friction_limit = c.friction_coefficient * c.normal_force.abs();
    const Scalars length = row_dot(tested, tested).sqrt();
    const auto slips = (length > friction_limit).eval();
    const Scalars scale = friction_limit / length;  // not a number where nothing acts; not used there
    const auto rewrites = (slips && c.tangential_stiffness > Real(0)).eval();
    const Scalars compliance = 1 / c.tangential_stiffness;  // infinite without a spring; not used there
    for (int d = 0; d < 3; ++d) {
      const Scalars cut = tested.col(d) * scale;
      auto displacement = c.tangential_displacement.col(d);
      auto force = c.tangential_force.col(d);
      // delta_t such that its spring exerts the cut force; under `lammps` the cut force less what all but the
      // spring exert, which is the damping.
      if (slip_history_ == SlipHistory::lammps)
        displacement = rewrites.select((force - cut) * compliance + displacement, displacement);
      else if (slip_history_ != SlipHistory::paper)
        displacement = rewrites.select(-cut * compliance, displacement);
      force = slips.select(cut, force);
    }
  }

 private:
  using Scalars = typename ContactBatch<Real>::Scalars;
  using Vectors = typename ContactBatch<Real>::Vectors;
  SlipHistory slip_history_;
};

}  // namespace

template <class Real>
void add_practical_model(ForceTermList<Real>& terms, const ModelOptions& options) {
  terms.add(std::make_unique<HertzMindlin<Real>>());
  terms.add(std::make_unique<NormalSpring<Real>>());
  terms.add(std::make_unique<NormalDamping<Real>>());
  terms.add(std::make_unique<TangentialSpring<Real>>());
  terms.add(std::make_unique<TangentialDamping<Real>>());
  if (options.normal_force == NormalForce::repulsive) terms.add(std::make_unique<RepulsiveLimit<Real>>());
  terms.add(std::make_unique<CoulombLimit<Real>>(options.slip_history));
}

template void add_practical_model(ForceTermList<float>&, const ModelOptions&);
template void add_practical_model(ForceTermList<double>&, const ModelOptions&);

}  // namespace warpgrain
