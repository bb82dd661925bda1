// The arrays of a step on a device, declared once. Valid OpenCL C and C++. No 3-vectors: they take 12 bytes in CUDA
// and 16 in OpenCL.
#ifndef WARPGRAIN_LAYOUT_H
#define WARPGRAIN_LAYOUT_H

#endif
