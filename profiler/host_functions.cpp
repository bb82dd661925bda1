#include "profiler/host_functions.hpp"

#include <atomic>
#include <cmath>
#include <cstdint>

#include "profiler/directed_rounding.hpp"
#include "profiler/half.hpp"
#include "profiler/printf_function.hpp"

namespace warpgrain::profiler {
namespace {

// Evaluated in double and rounded once.
float host_sin(float x) { return static_cast<float>(std::sin(static_cast<double>(x))); }
float host_cos(float x) { return static_cast<float>(std::cos(static_cast<double>(x))); }
float host_ex2(float x) { return static_cast<float>(std::exp2(static_cast<double>(x))); }
float host_lg2(float x) { return static_cast<float>(std::log2(static_cast<double>(x))); }
float host_tanh(float x) { return static_cast<float>(std::tanh(static_cast<double>(x))); }

// atom.inc and atom.dec: counters that wrap at `bound`. Both return what was there before.
std::uint32_t atomic_increment(std::uint32_t* place, std::uint32_t bound) {
  std::atomic_ref<std::uint32_t> counter(*place);
  std::uint32_t old = counter.load();
  while (!counter.compare_exchange_weak(old, old >= bound ? 0 : old + 1)) {
  }
  return old;
}

std::uint32_t atomic_decrement(std::uint32_t* place, std::uint32_t bound) {
  std::atomic_ref<std::uint32_t> counter(*place);
  std::uint32_t old = counter.load();
  while (!counter.compare_exchange_weak(old, old == 0 || old > bound ? bound : old - 1)) {
  }
  return old;
}

// fns: the place of a set bit of the mask, counted from `base`: 0 asks for that one itself, n above 0 for the
// n-th upwards, below 0 downwards. All ones when there is none.
std::uint32_t find_nth_set(std::uint32_t mask, std::int32_t base, std::int32_t offset) {
  const std::int32_t step = offset < 0 ? -1 : 1;
  std::int64_t left = offset == 0 ? 1 : std::abs(static_cast<std::int64_t>(offset));
  for (std::int32_t place = base; place >= 0 && place < 32; place += step) {
    if ((mask >> place & 1) != 0 && --left == 0) return static_cast<std::uint32_t>(place);
    if (offset == 0) break;
  }
  return ~std::uint32_t{0};
}

}  // namespace

std::vector<HostFunction> host_functions() {
  std::vector<HostFunction> functions = directed_functions();
  functions.insert(functions.end(), {
                                        host_function("warpgrain_sin", host_sin),
                                        host_function("warpgrain_cos", host_cos),
                                        host_function("warpgrain_ex2", host_ex2),
                                        host_function("warpgrain_lg2", host_lg2),
                                        host_function("warpgrain_tanh", host_tanh),
                                        host_function("warpgrain_fma_f16", fma_half),
                                        host_function("warpgrain_printf", print_arguments),
                                        host_function("warpgrain_vprintf", print_packed),
                                        host_function("warpgrain_find_nth_set", find_nth_set),
                                        host_function("warpgrain_atomic_inc", atomic_increment),
                                        host_function("warpgrain_atomic_dec", atomic_decrement),
                                    });
  return functions;
}

}  // namespace warpgrain::profiler
