// Sums of warps by shuffles and votes. shuffles.ptx: nvcc -ptx -arch=sm_80 -lineinfo shuffles.cu
extern "C" __global__ void shuffles(const unsigned* in, unsigned* sums, unsigned* ballots) {
  const unsigned id = blockIdx.x * blockDim.x + threadIdx.x;
  unsigned value = in[id];
  const unsigned odd = __ballot_sync(0xffffffffu, value & 1);
  for (unsigned offset = 16; offset > 0; offset /= 2) value += __shfl_down_sync(0xffffffffu, value, offset);
  if (threadIdx.x % 32 == 0) sums[id / 32] = value;
  if (value % 3 == 0) {
    value = __popc(odd) + value / 7;
  }
  __syncwarp();
  ballots[id] = value;
}
