#pragma once
// The back end `simt`, and one like it for studies of accuracy: not in backends(), since its results are no
// device's, but the worst that any may have.

#include "variants/backend.hpp"

namespace warpgrain {

extern const Backend simt_backend;
extern const Backend simt_approximate_backend;

}  // namespace warpgrain
