#pragma once
// The back end `opencl`.

#include "variants/backend.hpp"

namespace warpgrain {

extern const Backend opencl_backend;

}  // namespace warpgrain
