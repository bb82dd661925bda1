#pragma once
// The back end `cuda`.

#include "variants/backend.hpp"

namespace warpgrain {

extern const Backend cuda_backend;

}  // namespace warpgrain
