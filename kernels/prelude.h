// What every kernel file includes first: the dialect of the platform, then the layout of the data.
#ifndef WARPGRAIN_PRELUDE_H
#define WARPGRAIN_PRELUDE_H

#ifdef __OPENCL_C_VERSION__
#include "prelude_opencl.h"
#endif
#include "layout.h"

#endif
