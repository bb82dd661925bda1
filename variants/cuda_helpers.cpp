#include "variants/cuda_helpers.hpp"

#include <algorithm>
#include <array>
#include <fmt/format.h>
#include <string>

namespace warpgrain {
namespace {

constexpr const char* delay_ptx = R"(.version 6.0
.target sm_50
.address_size 64
.visible .entry warpgrain_delay(.param .u64 nanoseconds) {
  .reg .pred %p<2>;
  .reg .b64 %rd<5>;
  ld.param.u64 %rd1, [nanoseconds];
  mov.u64 %rd2, %globaltimer;
again:
  mov.u64 %rd3, %globaltimer;
  sub.u64 %rd4, %rd3, %rd2;
  setp.lt.u64 %p1, %rd4, %rd1;
  @%p1 bra again;
  ret;
}
)";

// Both addresses are written, so that the memory before the one in question is not dropped as unused.
constexpr const char* shared_ptx = R"(.version 6.0
.target sm_50
.address_size 64
.extern .shared .align 256 .b8 added[];
.visible .entry warpgrain_shared_memory(.param .u64 out) {{
  .reg .b64 %rd<4>;
  .shared .align 16 .b8 own[{}];
  ld.param.u64 %rd1, [out];
  mov.u64 %rd2, added;
  mov.u64 %rd3, own;
  st.global.u64 [%rd1], %rd2;
  st.global.u64 [%rd1+8], %rd3;
  ret;
}}
)";

}  // namespace

CudaDelay::CudaDelay(const CudaDevice& device)
    : module_(device, delay_ptx, "delay"), function_(module_.function("warpgrain_delay")) {}

void CudaDelay::launch(double seconds) const {
  auto nanoseconds = static_cast<std::uint64_t>(1e9 * seconds);
  std::array<void*, 1> parameters{&nanoseconds};
  function_.launch({1, 1, 1}, {1, 1, 1}, 0, parameters);
}

std::uint64_t shared_memory_begin(const CudaDevice& device, int static_bytes) {
  const CudaModule module(device, fmt::format(shared_ptx, std::max(static_bytes, 1)), "shared memory");
  CudaMemory out(device, 2 * sizeof(std::uint64_t));
  CudaAddress address = out.address();
  std::array<void*, 1> parameters{&address};
  module.function("warpgrain_shared_memory").launch({1, 1, 1}, {1, 1, 1}, 256, parameters);
  std::array<std::uint64_t, 2> begins{};
  out.read(std::as_writable_bytes(std::span(begins)));
  return begins[0];
}

}  // namespace warpgrain
