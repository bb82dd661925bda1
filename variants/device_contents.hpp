#pragma once
// What kernels get of a scene: the parameters of launches, and what arrays hold before the first evaluation.

#include "core/collision_grid.hpp"
#include "core/scene.hpp"
#include "variants/device_scene.hpp"

namespace warpgrain {

// Fills `parameters` and `contents` of a device whose numbers stand; part of lay_out, and throws as that
// does.
void fill_contents(const Scene& scene, const GridGeometry& grid, DeviceScene& device);

}  // namespace warpgrain
