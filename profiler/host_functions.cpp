#include "profiler/host_functions.hpp"

#include <atomic>
#include <cmath>
#include <cstdint>

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

template <class Function>
void* address_of(Function* function) {
  return reinterpret_cast<void*>(function);
}

}  // namespace

std::span<const HostFunction> host_functions() {
  static const HostFunction functions[] = {
      {"warpgrain_sin", address_of(host_sin)},
      {"warpgrain_cos", address_of(host_cos)},
      {"warpgrain_ex2", address_of(host_ex2)},
      {"warpgrain_lg2", address_of(host_lg2)},
      {"warpgrain_tanh", address_of(host_tanh)},
      {"warpgrain_atomic_inc", address_of(atomic_increment)},
      {"warpgrain_atomic_dec", address_of(atomic_decrement)},
  };
  return functions;
}

}  // namespace warpgrain::profiler
