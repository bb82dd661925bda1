#pragma once
// Single PTX instructions against C++ references: each runs once a lane, on edge values and random ones.
//
// A snippet finds its inputs a, b and c in %d0..%d2 (64 bits), %r0..%r2, %h0..%h2 (their low bits), %f0..%f2
// and %g0..%g2 (the bits as f32 and f64) and %p0..%p2 (whether they are odd); it may write any register
// numbered 3 to 7.

#include <cmath>
#include <cstdint>
#include <cstring>
#include <fmt/format.h>
#include <functional>
#include <gtest/gtest.h>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler {

struct BenchInputs {
  std::uint64_t a, b, c;
};

template <class T>
T from_bits(std::uint64_t bits) {
  T value;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}

template <class T>
std::uint64_t to_bits(T value) {
  std::uint64_t bits = 0;
  std::memcpy(&bits, &value, sizeof value);
  return bits;
}

using Reference = std::function<std::uint64_t(const BenchInputs&)>;

// A reference from a function of one to three values of type T.
template <class T, class F>
Reference on(F function) {
  return [function](const BenchInputs& in) {
    const T a = from_bits<T>(in.a);
    const T b = from_bits<T>(in.b);
    const T c = from_bits<T>(in.c);
    if constexpr (std::is_invocable_v<F, T, T, T>)
      return to_bits(function(a, b, c));
    else if constexpr (std::is_invocable_v<F, T, T>)
      return to_bits(function(a, b));
    else
      return to_bits(function(a));
  };
}

class InstructionBench {
 public:
  // `result` is the register whose bits are compared; of f and g registers all NaNs count as equal.
  void expect(const std::string& code, const std::string& result, Reference reference) {
    cases_.push_back({code, result, std::move(reference)});
  }

  void run(const std::vector<BenchInputs>& inputs) const {
    std::vector<BenchInputs> in = inputs;
    std::vector<std::uint64_t> out(cases_.size() * in.size());
    const auto executable =
        Executable::compile(ptx(in.size()), "bench", TraceMode::blocks_and_addresses, "bench.ptx");
    run_launch(*executable, line_of(in.size(), 1), {buffer_of(in), buffer_of(out)});
    for (std::size_t i = 0; i < cases_.size(); ++i)
      for (std::size_t lane = 0; lane < in.size(); ++lane) {
        const std::uint64_t expected = cases_[i].reference(in[lane]);
        const std::uint64_t got = out[i * in.size() + lane];
        if (got == expected || (is_nan(cases_[i], got) && is_nan(cases_[i], expected))) continue;
        ADD_FAILURE() << cases_[i].code
                      << fmt::format(" of {:#x}, {:#x}, {:#x}: got {:#x}, expected {:#x}", in[lane].a,
                                     in[lane].b, in[lane].c, got, expected);
        break;
      }
  }

 private:
  struct Case {
    std::string code, result;
    Reference reference;
  };

  static bool is_nan(const Case& c, std::uint64_t bits) {
    if (c.result[1] == 'f') return std::isnan(from_bits<float>(bits));
    return c.result[1] == 'g' && std::isnan(from_bits<double>(bits));
  }

  static std::string store(const std::string& result) {
    switch (result[1]) {
      case 'r':
        return fmt::format("cvt.u64.u32 %t, {};", result);
      case 'h':
        return fmt::format("cvt.u64.u16 %t, {};", result);
      case 'f':
        return fmt::format("mov.b32 %r8, {}; cvt.u64.u32 %t, %r8;", result);
      case 'p':
        return fmt::format("selp.u64 %t, 1, 0, {};", result);
      default:
        return fmt::format("mov.b64 %t, {};", result);
    }
  }

  std::string ptx(std::size_t lanes) const {
    std::string text = R"(.version 7.5
.target sm_70
.address_size 64
.entry bench(.param .u64 .ptr .global in, .param .u64 .ptr .global out)
{
.reg .pred %p<8>; .reg .b16 %h<8>; .reg .b32 %r<9>; .reg .b64 %d<8>; .reg .f32 %f<8>; .reg .f64 %g<8>;
.reg .b64 %in, %out, %t; .reg .b32 %lane;
ld.param.u64 %in, [in]; ld.param.u64 %out, [out];
mov.u32 %lane, %ctaid.x; mad.wide.u32 %in, %lane, 24, %in; mad.wide.u32 %out, %lane, 8, %out;
)";
    for (std::size_t i = 0; i < cases_.size(); ++i) {
      for (int k = 0; k < 3; ++k)
        text += fmt::format(
            "ld.global.u64 %d{0}, [%in+{1}]; cvt.u32.u64 %r{0}, %d{0}; cvt.u16.u64 %h{0}, %d{0}; mov.b32 "
            "%f{0}, %r{0}; "
            "mov.b64 %g{0}, %d{0}; and.b32 %r8, %r{0}, 1; setp.ne.u32 %p{0}, %r8, 0;\n",
            k, k * 8);
      text += fmt::format("{}\n{}\nst.global.u64 [%out+{}], %t;\n", cases_[i].code, store(cases_[i].result),
                          i * lanes * 8);
    }
    return text + "ret;\n}\n";
  }

  std::vector<Case> cases_;
};

// Every combination of edge values, then random ones.
template <class T>
std::vector<BenchInputs> combine(const std::vector<T>& values,
                                 const std::function<T(std::mt19937_64&)>& random_value) {
  std::vector<BenchInputs> inputs;
  for (const T a : values)
    for (const T b : values)
      inputs.push_back({to_bits(a), to_bits(b), to_bits(values[inputs.size() % values.size()])});
  std::mt19937_64 random(20240501);
  for (int i = 0; i < 200; ++i)
    inputs.push_back(
        {to_bits(random_value(random)), to_bits(random_value(random)), to_bits(random_value(random))});
  return inputs;
}

inline std::vector<BenchInputs> integer_inputs() {
  return combine<std::uint64_t>({0,
                                 1,
                                 2,
                                 7,
                                 31,
                                 32,
                                 33,
                                 63,
                                 64,
                                 255,
                                 0x7f,
                                 0x80,
                                 0x7fff,
                                 0x8000,
                                 0xffff,
                                 0x7fffffff,
                                 0x80000000,
                                 0xffffffff,
                                 0x123456789abcdef0,
                                 0x7fffffffffffffff,
                                 0x8000000000000000,
                                 0xffffffffffffffff},
                                [](std::mt19937_64& random) { return random() >> (random() % 64); });
}

inline std::vector<BenchInputs> float_inputs() {
  using Limits = std::numeric_limits<float>;
  return combine<float>({0.0f,
                         -0.0f,
                         1.0f,
                         -1.0f,
                         0.5f,
                         1.5f,
                         2.5f,
                         -2.5f,
                         3.7f,
                         -1e-3f,
                         255.9f,
                         1e10f,
                         -3e9f,
                         Limits::max(),
                         Limits::min(),
                         Limits::denorm_min(),
                         -1e-40f,
                         Limits::infinity(),
                         -Limits::infinity(),
                         Limits::quiet_NaN()},
                        [](std::mt19937_64& random) {
                          return std::ldexp(std::uniform_real_distribution<float>(-1, 1)(random),
                                            static_cast<int>(random() % 60) - 30);
                        });
}

inline std::vector<BenchInputs> double_inputs() {
  using Limits = std::numeric_limits<double>;
  return combine<double>(
      {0.0, -0.0, 1.0, -1.0, 0.5, 2.5, -3.5, 1e10, -3e9, 1e19, Limits::max(), Limits::min(),
       Limits::denorm_min(), Limits::infinity(), -Limits::infinity(), Limits::quiet_NaN()},
      [](std::mt19937_64& random) {
        return std::ldexp(std::uniform_real_distribution<double>(-1, 1)(random),
                          static_cast<int>(random() % 120) - 60);
      });
}

}  // namespace warpgrain::profiler
