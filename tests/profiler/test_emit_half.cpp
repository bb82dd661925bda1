// Arithmetic of halfs, alone and in pairs, against double arithmetic that is rounded once.

#include <algorithm>
#include <cmath>

#include "profiler/half.hpp"
#include "tests/profiler/instruction_bench.hpp"

namespace warpgrain::profiler {
namespace {

double value(std::uint16_t bits) { return half_to_float(bits); }
std::uint16_t nearest(double x) { return double_to_half(x, HalfRounding::to_nearest); }
std::uint16_t flushed(std::uint16_t bits) {
  return (bits & 0x7c00) == 0 ? static_cast<std::uint16_t>(bits & 0x8000) : bits;
}

using HalfFunction = std::function<std::uint16_t(std::uint16_t, std::uint16_t, std::uint16_t)>;

// On the low halfs of the inputs.
Reference single(HalfFunction f) {
  return [f](const BenchInputs& in) -> std::uint64_t {
    return f(static_cast<std::uint16_t>(in.a), static_cast<std::uint16_t>(in.b),
             static_cast<std::uint16_t>(in.c));
  };
}

// On both halfs of their low words.
Reference pair(HalfFunction f) {
  return [f](const BenchInputs& in) -> std::uint64_t {
    const auto of = [](std::uint64_t bits, int i) { return static_cast<std::uint16_t>(bits >> (16 * i)); };
    const std::uint32_t low = f(of(in.a, 0), of(in.b, 0), of(in.c, 0));
    const std::uint32_t high = f(of(in.a, 1), of(in.b, 1), of(in.c, 1));
    return high << 16 | low;
  };
}

std::vector<BenchInputs> inputs() {
  std::vector<std::uint64_t> words;
  for (const std::uint64_t half : {0x0000, 0x8000, 0x0001, 0x83ff, 0x0400, 0x3c00, 0xbc00, 0x3bff, 0x4200,
                                   0x7bff, 0xfbff, 0x7c00, 0xfc00, 0x7e01, 0x3555})
    words.push_back(half | (half ^ 0x1234) << 16);
  return combine<std::uint64_t>(words, [](std::mt19937_64& random) { return random(); });
}

// The same instruction on halfs and on pairs of them.
void expect_both(InstructionBench& bench, const std::string& opcode, const std::string& operands,
                 const HalfFunction& f) {
  std::string of_pairs = operands;
  std::replace(of_pairs.begin(), of_pairs.end(), 'h', 'r');
  bench.expect(opcode + ".f16 " + operands + ";", "%h3", single(f));
  bench.expect(opcode + ".f16x2 " + of_pairs + ";", "%r3", pair(f));
}

TEST(EmitHalf, SumsProductsAndFused) {
  InstructionBench bench;
  const std::string two = "%h3, %h0, %h1", three = "%h3, %h0, %h1, %h2";
  expect_both(bench, "add", two, [](auto a, auto b, auto) { return nearest(value(a) + value(b)); });
  expect_both(bench, "add.rn", two, [](auto a, auto b, auto) { return nearest(value(a) + value(b)); });
  expect_both(bench, "sub.rn", two, [](auto a, auto b, auto) { return nearest(value(a) - value(b)); });
  expect_both(bench, "mul.rn", two, [](auto a, auto b, auto) { return nearest(value(a) * value(b)); });
  expect_both(bench, "fma.rn", three, [](auto a, auto b, auto c) { return fma_half(a, b, c); });
  expect_both(bench, "mul.ftz", two,
              [](auto a, auto b, auto) { return flushed(nearest(value(flushed(a)) * value(flushed(b)))); });
  expect_both(bench, "fma.rn.sat", three, [](auto a, auto b, auto c) {
    const double sum = value(fma_half(a, b, c));
    return std::isnan(sum) || sum <= 0 ? std::uint16_t{0} : nearest(std::min(sum, 1.0));
  });
  expect_both(bench, "fma.rn.relu", three, [](auto a, auto b, auto c) {
    const std::uint16_t sum = fma_half(a, b, c);
    return value(sum) < 0 ? std::uint16_t{0} : sum;
  });
  bench.run(inputs());
}

TEST(EmitHalf, SignsAndExtremes) {
  InstructionBench bench;
  const auto is_nan = [](std::uint16_t bits) { return (bits & 0x7fff) > 0x7c00; };
  expect_both(bench, "neg", "%h3, %h0", [is_nan](auto a, auto, auto) {
    return is_nan(a) ? std::uint16_t{0x7fff} : static_cast<std::uint16_t>(a ^ 0x8000);
  });
  expect_both(bench, "abs", "%h3, %h0", [is_nan](auto a, auto, auto) {
    return is_nan(a) ? std::uint16_t{0x7fff} : static_cast<std::uint16_t>(a & 0x7fff);
  });
  for (const bool is_min : {true, false})
    for (const bool keeps_nan : {true, false})
      expect_both(bench, std::string(is_min ? "min" : "max") + (keeps_nan ? ".NaN" : ""), "%h3, %h0, %h1",
                  [=](auto a, auto b, auto) -> std::uint16_t {
                    if (is_nan(a) || is_nan(b))
                      return keeps_nan || (is_nan(a) && is_nan(b)) ? 0x7fff : is_nan(a) ? b : a;
                    const double x = value(a), y = value(b);
                    const bool a_first = x != y ? x < y : std::signbit(x);
                    return a_first == is_min ? a : b;
                  });
  bench.run(inputs());
}

TEST(EmitHalf, ConversionsInEveryRounding) {
  InstructionBench bench;
  const std::vector<std::pair<std::string, HalfRounding>> roundings{{"rn", HalfRounding::to_nearest},
                                                                    {"rz", HalfRounding::towards_zero},
                                                                    {"rm", HalfRounding::down},
                                                                    {"rp", HalfRounding::up}};
  for (const auto& [name, rounding] : roundings) {
    const auto from = [rounding = rounding](double x) -> std::uint64_t {
      return double_to_half(x, rounding);
    };
    const auto expect = [&](const std::string& type, const std::string& source, auto convert) {
      bench.expect("cvt." + name + ".f16." + type + " %h3, " + source + ";", "%h3",
                   [=](const BenchInputs& in) { return from(static_cast<double>(convert(in.a))); });
    };
    expect("s16", "%h0", [](std::uint64_t a) { return static_cast<std::int16_t>(a); });
    expect("u16", "%h0", [](std::uint64_t a) { return static_cast<std::uint16_t>(a); });
    expect("s32", "%r0", [](std::uint64_t a) { return static_cast<std::int32_t>(a); });
    expect("u32", "%r0", [](std::uint64_t a) { return static_cast<std::uint32_t>(a); });
    expect("s64", "%d0", [](std::uint64_t a) { return static_cast<std::int64_t>(a); });
    expect("u64", "%d0", [](std::uint64_t a) { return a; });
  }
  bench.run(integer_inputs());
}

}  // namespace
}  // namespace warpgrain::profiler
