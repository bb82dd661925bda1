#pragma once
// The back end `simt`.

#include "variants/backend.hpp"

namespace warpgrain {

extern const Backend simt_backend;

}  // namespace warpgrain
