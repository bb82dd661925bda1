#pragma once
// What a variant's arithmetic means for the choice of a time step.

#include "core/time_step_advice.hpp"
#include "variants/axes.hpp"

namespace warpgrain {

// How far apart neighbouring places are in the variant's precision, where the scene is farthest from the
// origin. Throws InputError as fixed_point_for() does.
StepArithmetic step_arithmetic(const Scene& scene, const Variant& variant);

}  // namespace warpgrain
