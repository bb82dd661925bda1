#include "variants/contact_laws.hpp"

#include <array>

namespace warpgrain {

// Bounds: three times the largest deviation seen, 1.6e-5 and 3e-14 in 400 random beds as
// tests/variants/test_conformance.cpp makes them. At rest: 1.9e-4 in float and 3e-14 in the scene settled_bed
// of 131072 particles (reports/measured/), simple 7.3e-6 in float at 16384. In double rounded up, since other
// devices contract and divide differently.
std::span<const ContactLaw> contact_laws() {
  static constexpr std::array<ContactLaw, 4> laws{{
      {"simple",
       "eq. (1): linear spring, damping and shear; no rotation, no memory",
       "contact/simple.cl",
       ContactModel::simple,
       false,
       {5e-5, 1e-12},
       {5e-5, 1e-12}},
      {"branchy",
       "eqs. (2)-(10), the practical model with its natural if-branches",
       "contact/branchy.cl",
       ContactModel::practical,
       true,
       {5e-5, 1e-12},
       {6e-4, 1e-12}},
      {"branchless",
       "eqs. (2)-(10) with selects in place of every if: all contacts pay for what one that slips needs",
       "contact/branchless.cl",
       ContactModel::practical,
       true,
       {5e-5, 1e-12},
       {6e-4, 1e-12}},
      {"sfu_minimised",
       "eqs. (2)-(10) with two operations on the special-function unit in a contact that does not slip",
       "contact/sfu_minimised.cl",
       ContactModel::practical,
       true,
       {5e-5, 1e-12},
       {6e-4, 1e-12}},
  }};
  return laws;
}

}  // namespace warpgrain
