// Kernels whose lanes work together. Their PTX: nvcc -ptx -arch=sm_80 -lineinfo warp_kernels.cu
constexpr unsigned all_lanes = 0xffffffff;

// The sum of each block, by shuffles in every warp and once more over the warps.
__device__ int warp_sum(int x) {
  for (int offset = 16; offset > 0; offset /= 2) x += __shfl_down_sync(all_lanes, x, offset);
  return x;
}
__global__ void shuffle_reduction(int* sums, const int* in) {
  __shared__ int of_warps[32];
  const int total = warp_sum(in[blockIdx.x * blockDim.x + threadIdx.x]);
  if (threadIdx.x % 32 == 0) of_warps[threadIdx.x / 32] = total;
  __syncthreads();
  if (threadIdx.x < 32) {
    const int sum = warp_sum(threadIdx.x < blockDim.x / 32 ? of_warps[threadIdx.x] : 0);
    if (threadIdx.x == 0) sums[blockIdx.x] = sum;
  }
}

// Running sums of each warp.
__global__ void warp_scan(int* out, const int* in) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x, lane = threadIdx.x % 32;
  int x = in[i];
  for (int offset = 1; offset < 32; offset *= 2) {
    const int below = __shfl_up_sync(all_lanes, x, offset);
    if (lane >= offset) x += below;
  }
  out[i] = x;
}

// The positive values of each warp, moved to its front; how many there are.
__global__ void ballot_compaction(int* out, int* counts, const int* in) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  const int x = in[i];
  const unsigned kept = __ballot_sync(all_lanes, x > 0);
  unsigned below;
  asm("mov.u32 %0, %%lanemask_lt;" : "=r"(below));
  if (x > 0) out[i / 32 * 32 + __popc(kept & below)] = x;
  if (threadIdx.x % 32 == 0) counts[i / 32] = __popc(kept);
}

// One atomic for all lanes of a warp with the same value.
__global__ void match_histogram(int* bins, const int* in) {
  const int x = in[blockIdx.x * blockDim.x + threadIdx.x];
  const unsigned same = __match_any_sync(all_lanes, x);
  if (threadIdx.x % 32 == __ffs(same) - 1) atomicAdd(&bins[x], __popc(same));
}

// A square tile of the block's width through shared memory that the launch sizes.
template <class T>
__global__ void transpose(T* out, const T* in, int width) {
  extern __shared__ int tile[];
  const int x = blockIdx.x * blockDim.x + threadIdx.x, y = blockIdx.y * blockDim.y + threadIdx.y;
  const int pitch = blockDim.x + 1;
  tile[threadIdx.y * pitch + threadIdx.x] = in[y * width + x];
  __syncthreads();
  const int to_x = blockIdx.y * blockDim.y + threadIdx.x, to_y = blockIdx.x * blockDim.x + threadIdx.y;
  out[to_y * width + to_x] = tile[threadIdx.x * pitch + threadIdx.y];
}
template __global__ void transpose<int>(int*, const int*, int);

// One warp fills one of two buffers while another empties the other; numbered barriers of 64 threads say
// which is full and which is empty.
__global__ void producer_consumer(int* out, const int* in, int rounds) {
  __shared__ int buffers[2][32];
  const int lane = threadIdx.x % 32;
  const bool produces = threadIdx.x < 32;  // branch: role of the warp
  for (int round = 0; round < rounds; ++round) {
    const int full = 1 + round % 2, empty = 3 + round % 2;
    if (produces) {
      if (round >= 2) asm volatile("bar.sync %0, 64;" ::"r"(empty) : "memory");
      buffers[round % 2][lane] = 3 * in[round * 32 + lane];
      asm volatile("bar.arrive %0, 64;" ::"r"(full) : "memory");
    } else {
      asm volatile("bar.sync %0, 64;" ::"r"(full) : "memory");
      out[round * 32 + lane] = buffers[round % 2][31 - lane];
      if (round + 2 < rounds) asm volatile("bar.arrive %0, 64;" ::"r"(empty) : "memory");
    }
  }
}

// Lanes leave the loop one by one; those that are left vote.
__global__ void loop_of_votes(int* out, const int* in) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  int n = in[i] % 7, seen = 0;
  while (n-- > 0) seen += __popc(__activemask());
  out[i] = seen;
}

// Shapes behind a base class: calls through a table of functions.
struct Shape {
  __device__ virtual int area(int x) const = 0;
};
struct Square : Shape {
  __device__ int area(int x) const override { return x * x; }
};
struct Stripes : Shape {
  __device__ int area(int x) const override {
    int sum = 0;
    for (int i = 0; i < x; ++i) sum += i % 3;
    return sum;
  }
};
__global__ void virtual_calls(int* out, const int* in) {
  const int i = blockIdx.x * blockDim.x + threadIdx.x;
  const Square square;
  const Stripes stripes;
  const Shape* const shapes[2] = {&square, &stripes};
  out[i] = shapes[in[i] % 2]->area(in[i]);
}
