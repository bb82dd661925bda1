#include "variants/contact_laws.hpp"

#include <algorithm>
#include <array>

namespace warpgrain {

// Bounds: three times the largest deviation seen, 1.6e-5 and 3e-14 in 400 random beds as
// tests/variants/test_conformance.cpp makes them; 8e-4 in float in the scene settled_bed of 2048 particles
// while it came to rest. In double rounded up, since other devices contract and divide differently.
std::span<const ContactLaw> contact_laws() {
  static constexpr std::array<ContactLaw, 2> laws{{
      {"simple",
       "eq. (1): linear spring, damping and shear; no rotation, no memory",
       "contact/simple.cl",
       ContactModel::simple,
       false,
       {5e-5, 1e-12},
       {3e-3, 1e-11}},
      {"branchy",
       "eqs. (2)-(10), the practical model with its natural if-branches",
       "contact/branchy.cl",
       ContactModel::practical,
       true,
       {5e-5, 1e-12},
       {3e-3, 1e-11}},
  }};
  return laws;
}

const ContactLaw& contact_law(const Variant& variant) {
  return *std::ranges::find(contact_laws(), variant.value(AxisId::contact), &ContactLaw::name);
}

}  // namespace warpgrain
