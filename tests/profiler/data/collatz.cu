// The source of collatz.ptx: nvcc -ptx -arch=sm_80 -lineinfo collatz.cu
struct Limits { unsigned most; float scale; };
__constant__ unsigned bonus[4] = {1, 10, 100, 1000};
__device__ __noinline__ unsigned steps_of(unsigned x, unsigned most) {
  unsigned steps = 0;
  while (x != 1 && steps < most) {
    x = x & 1 ? 3 * x + 1 : x / 2;
    ++steps;
  }
  return steps;
}
extern "C" __global__ void collatz(unsigned* out, const unsigned* __restrict__ in, Limits limits) {
  __shared__ unsigned steps[64];
  const unsigned i = blockIdx.x * blockDim.x + threadIdx.x;
  steps[threadIdx.x] = steps_of(in[i], limits.most);
  __syncthreads();
  const unsigned other = steps[blockDim.x - 1 - threadIdx.x];
  atomicMax(&out[gridDim.x * blockDim.x], other);
  out[i] = other * 4 + bonus[i % 4] + __float2uint_rn(expf(0.0f) * limits.scale);
}
