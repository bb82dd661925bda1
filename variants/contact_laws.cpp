#include "variants/contact_laws.hpp"

#include <algorithm>
#include <array>

namespace warpgrain {

std::span<const ContactLaw> contact_laws() {
  static constexpr std::array<ContactLaw, 2> laws{{
      {"simple",
       "eq. (1): linear spring, damping and shear; no rotation, no memory",
       "contact/simple.cl",
       ContactModel::simple,
       false,
       {2e-5, 1e-12}},
      {"branchy",
       "eqs. (2)-(10), the practical model with its natural if-branches",
       "contact/branchy.cl",
       ContactModel::practical,
       true,
       {2e-5, 1e-12}},
  }};
  return laws;
}

const ContactLaw& contact_law(const Variant& variant) {
  return *std::ranges::find(contact_laws(), variant.value(AxisId::contact), &ContactLaw::name);
}

}  // namespace warpgrain
