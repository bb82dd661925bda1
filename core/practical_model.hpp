#pragma once
// The practical model, eqs. (2)-(10): Hertz-Mindlin springs, damping, and Coulomb friction with a memory.
// Terms, in the order of application:
//   "hertz_mindlin"       k_n, k_t and eta of the contact, eqs. (8)-(10)
//   "normal_spring"       F_n = -k_n overlap, eq. (4)
//   "normal_damping"      F_n -= eta v.n, eq. (4)
//   "tangential_spring"   delta_t by eq. (7), then F_t = -k_t delta_t, eq. (4); keeps the history
//   "tangential_damping"  F_t -= eta v_t, eq. (4)
//   "repulsive_limit"     F_n never pulls; with NormalForce::repulsive only
//   "coulomb_limit"       eq. (5), and what it does to delta_t: SlipHistory

#include "core/force_term.hpp"

namespace warpgrain {

template <class Real>
void add_practical_model(ForceTermList<Real>& terms, const ModelOptions& options);

}  // namespace warpgrain
