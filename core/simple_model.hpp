#pragma once
// The simple model, eq. (1): the law of NVIDIA's SDK sample "particles". A linear spring along the normal, a
// damping of the whole relative velocity of the centres, and a damping ("shear") of its tangential part. No
// rotation, no memory. Terms: "simple_spring", "simple_damping", "simple_shear".

#include "core/force_term.hpp"

namespace warpgrain {

template <class Real>
void add_simple_model(ForceTermList<Real>& terms, const SimpleParameters& parameters);

}  // namespace warpgrain
