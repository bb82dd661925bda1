#pragma once
// PTX snippets that a warp or a work-group runs together, and what each lane leaves.
//
// A snippet finds its lane in %r0 (%tid.x) and may write any register %r1..%r9, %d1..%d3 and %p0..%p3; what
// it leaves in %r9 is the lane's result.

#include <cstdint>
#include <string>
#include <vector>

#include "tests/profiler/ptx_text.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {

inline std::string warp_kernel(const std::string& code) {
  return ptx_module(R"(.entry k(.param .u64 out) {
.reg .pred %p<4>; .reg .b32 %r<10>; .reg .b64 %d<5>;
.shared .align 4 .b8 scratch[4096];
mov.u32 %r0, %tid.x; mov.u32 %r9, 0;
)" + code + R"(
STORE: ld.param.u64 %d0, [out]; mul.wide.u32 %d4, %r0, 4; add.s64 %d0, %d0, %d4; st.global.u32 [%d0], %r9;
END: ret;
})");
}

// The results of a work-group of `lanes`.
inline std::vector<std::uint32_t> run_warp_snippet(const std::string& code, std::uint32_t lanes = 32) {
  const auto executable =
      Executable::compile(warp_kernel(code), "k", TraceMode::blocks_and_addresses, "k.ptx");
  std::vector<std::uint32_t> out(lanes);
  run_launch(*executable, line_of(lanes, lanes), {buffer_of(out)});
  return out;
}

// What running the snippet is refused with.
inline std::string refused_warp_snippet(const std::string& code, std::uint32_t lanes = 32) {
  return refusal([&] { run_warp_snippet(code, lanes); });
}

}  // namespace warpgrain::profiler
