// What every kernel file includes first: the dialect of the platform and the layout of the data.
#ifndef WARPGRAIN_PRELUDE_H
#define WARPGRAIN_PRELUDE_H

#ifdef __OPENCL_C_VERSION__
#include "prelude_opencl.h"
#endif
#include "layout.h"

DEVICE_FUNCTION real3 vector_of(const Triple t) { return make_real3(t.x, t.y, t.z); }

#endif
