#pragma once
// The back end `host`.

#include "variants/backend.hpp"

namespace warpgrain {

extern const Backend host_backend;

}  // namespace warpgrain
