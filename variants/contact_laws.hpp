#pragma once
// The contact laws: one row here and one .cl file in kernels/contact/. Everything else follows from the row:
// the axis value, the back ends, the sweep, the conformance test.

#include <span>
#include <string_view>

#include "core/model.hpp"
#include "variants/axes.hpp"

namespace warpgrain {

// Largest deviation from the double reference in one evaluation of the same state, as a part of the largest
// force in the bed: of a force; of a torque over the largest radius; of a tangential displacement times the
// contact's tangential stiffness. At rest the forces on a particle cancel to about its weight, while those of
// its contacts grow with the depth of the bed: so does what their rounding is of that largest force.
struct ErrorBounds {
  double fp32 = 0, fp64 = 0;
};

struct ContactLaw {
  std::string_view name;  // value of the axis `contact`
  std::string_view summary;
  std::string_view file;                         // in kernels/
  ContactModel model = ContactModel::practical;  // what the law computes, whatever the scene's model says
  bool keeps_history = true;
  ErrorBounds error_bounds;          // in beds whose overlaps are percents of a radius
  ErrorBounds error_bounds_at_rest;  // in settled beds to 2^17 particles
};

std::span<const ContactLaw> contact_laws();
// The law of a variant.
const ContactLaw& contact_law(const Variant& variant);

}  // namespace warpgrain
