#pragma once
// The space a scene takes, from its particles and walls.

#include "core/scene.hpp"

namespace warpgrain {

// The box around the particles as they start, the rectangles, and the planes that are perpendicular to an
// axis.
Box box_around(const Scene& scene);

// The domain of a scene whose file gives none: box_around, widened on every side by four of the largest radii
// and room for travel, then cut by the planes perpendicular to an axis. The room for travel is what the
// fastest particle covers until the end of the run, doubled for what impacts may add, free fall included; it
// is the box's longest side where a run ends at rest. It is halved as long as the domain would have more than
// 2^21 cells of the largest diameter.
Box derive_domain(const Scene& scene);

}  // namespace warpgrain
