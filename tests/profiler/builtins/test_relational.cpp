// Relational functions (section 6.12.6): 1 or 0 of scalars, -1 or 0 of vectors; selections bit by bit.

#include <bit>
#include <gtest/gtest.h>

#include "tests/profiler/builtins/scalar_types.hpp"
#include "tests/profiler/builtins/switch_program.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

template <std::size_t size>
using SignedOf = std::conditional_t<
    size == 1, std::int8_t,
    std::conditional_t<size == 2, std::int16_t, std::conditional_t<size == 4, std::int32_t, std::int64_t>>>;

template <class T>
struct Relation {
  std::string_view call;
  bool (*holds)(T x, T y);
};

template <class T>
std::vector<Relation<T>> relations() {
  return {{"isequal(x, y)", [](T x, T y) { return x == y; }},
          {"isnotequal(x, y)", [](T x, T y) { return x != y; }},
          {"isgreater(x, y)", [](T x, T y) { return x > y; }},
          {"isgreaterequal(x, y)", [](T x, T y) { return x >= y; }},
          {"isless(x, y)", [](T x, T y) { return x < y; }},
          {"islessequal(x, y)", [](T x, T y) { return x <= y; }},
          {"islessgreater(x, y)", [](T x, T y) { return x < y || x > y; }},
          {"isordered(x, y)", [](T x, T y) { return !std::isunordered(x, y); }},
          {"isunordered(x, y)", [](T x, T y) { return std::isunordered(x, y); }},
          {"isfinite(x)", [](T x, T) { return std::isfinite(x); }},
          {"isinf(x)", [](T x, T) { return std::isinf(x); }},
          {"isnan(x)", [](T x, T) { return std::isnan(x); }},
          {"isnormal(x)", [](T x, T) { return std::isnormal(x); }},
          {"signbit(x)", [](T x, T) { return std::signbit(x); }},
          {"x < y", [](T x, T y) { return x < y; }},
          {"x >= y", [](T x, T y) { return x >= y; }},
          {"x == y", [](T x, T y) { return x == y; }},
          {"x != y", [](T x, T y) { return x != y; }},
          {"!x", [](T x, T) { return x == 0; }},
          {"x && y", [](T x, T y) { return x != 0 && y != 0; }},
          {"x || y", [](T x, T y) { return x != 0 || y != 0; }}};
}

template <class T>
std::vector<T> partners(const std::vector<T>& x, Random& random) {
  std::vector<T> y = x;
  // Every fourth stays the same, so that some are equal.
  for (std::size_t i = 0; i < y.size(); ++i)
    if (i % 4 != 0) y[i] = x[random.below(x.size())];
  return y;
}

template <class T>
void expect_relations(std::uint32_t width) {
  using Mask = SignedOf<sizeof(T)>;
  Random random;
  std::vector<T> x = values_of<T>(random), y = partners(x, random);
  const std::vector<Relation<T>> all = relations<T>();
  std::vector<Expression> expressions;
  for (const Relation<T>& r : all) expressions.push_back({std::string(r.call), std::string(name_of<Mask>())});
  const auto executable =
      compile_kernel(switch_program(name_of<T>(), width, expressions), "measured", TraceMode::none);
  for (std::size_t r = 0; r < all.size(); ++r) {
    std::vector<Mask> results(x.size());
    const int which = static_cast<int>(r);
    run_launch(*executable, line_of(x.size() / width, 32),
               {buffer_of(results), buffer_of(x), buffer_of(y), buffer_of(y), scalar_of(which)});
    for (std::size_t i = 0; i < x.size(); ++i)
      ASSERT_EQ(results[i], all[r].holds(x[i], y[i]) ? (width == 1 ? 1 : -1) : 0) << fmt::format(
          "{}{}: {}, x = {}, y = {}, seed {}", name_of<T>(), width, all[r].call, x[i], y[i], seed);
  }
}

TEST(RelationalFunctions, OfFloats) {
  for (const std::uint32_t width : {1, 3, 16}) expect_relations<float>(width);
}

TEST(RelationalFunctions, OfDoubles) {
  for (const std::uint32_t width : {1, 3, 16}) expect_relations<double>(width);
}

template <class T>
auto bits_of(T x) {
  return std::bit_cast<SignedOf<sizeof(T)>>(x);
}

// bitselect and select of scalars and vectors; select looks at all of a scalar, at the highest bit of
// components.
template <class T>
void expect_selections(std::uint32_t width) {
  using Bits = SignedOf<sizeof(T)>;
  Random random;
  std::vector<T> x = values_of<T>(random), y = partners(x, random), z = partners(y, random);
  const std::string n = width == 1 ? "" : std::to_string(width), type(name_of<T>());
  const std::string mask = fmt::format("as_{}{}(z)", name_of<Bits>(), n);
  const std::string unsigned_mask = fmt::format("as_{}{}(z)", name_of<std::make_unsigned_t<Bits>>(), n);
  const auto executable =
      compile_kernel(switch_program(type, width,
                                    {{"bitselect(x, y, z)", type},
                                     {fmt::format("select(x, y, {})", mask), type},
                                     {fmt::format("select(x, y, {})", unsigned_mask), type}}),
                     "measured", TraceMode::none);
  for (const int which : {0, 1, 2}) {
    std::vector<T> results(x.size());
    run_launch(*executable, line_of(x.size() / width, 32),
               {buffer_of(results), buffer_of(x), buffer_of(y), buffer_of(z), scalar_of(which)});
    for (std::size_t i = 0; i < x.size(); ++i) {
      const Bits a = bits_of(x[i]), b = bits_of(y[i]), c = bits_of(z[i]);
      const Bits expected = which == 0                      ? static_cast<Bits>((a & ~c) | (b & c))
                            : (width == 1 ? c != 0 : c < 0) ? b
                                                            : a;
      ASSERT_EQ(bits_of(results[i]), expected)
          << fmt::format("{}{}, function {}, seed {}", type, width, which, seed);
    }
  }
}

TEST(RelationalFunctions, SelectBitsAndValues) {
  for_all_types([]<class T>(T) {
    for (const std::uint32_t width : {1, 3, 16}) expect_selections<T>(width);
  });
}

// any and all look at the highest bit of each component.
template <class T>
void expect_any_and_all(std::uint32_t width) {
  Random random;
  std::vector<T> x(sample_block);
  // Mostly all alike in a vector.
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<T>(random.below(8) == 0   ? random.bits()
                          : (i / width) % 2 == 0 ? ~std::uint64_t(0)
                                                 : 1);
  const std::string n = width == 1 ? "" : std::to_string(width);
  std::string text = fmt::format(
      "kernel void measured(global int* some, global int* every, global const {0}* xs) {{\n"
      "  const size_t i = get_global_id(0);\n  const {0}{1} x = {2};\n  some[i] = any(x);\n  every[i] = "
      "all(x);\n}}\n",
      name_of<T>(), n, width == 1 ? "xs[i]" : fmt::format("vload{}(i, xs)", n));
  const auto executable = compile_kernel(text, "measured", TraceMode::none);
  std::vector<int> some(x.size() / width), every(some.size());
  run_launch(*executable, line_of(some.size(), 32), {buffer_of(some), buffer_of(every), buffer_of(x)});
  for (std::size_t i = 0; i < some.size(); ++i) {
    std::uint32_t set = 0;
    for (std::uint32_t c = 0; c < width; ++c) set += x[i * width + c] < 0;
    ASSERT_EQ(some[i], set > 0) << name_of<T>() << width << ", seed " << seed;
    ASSERT_EQ(every[i], set == width) << name_of<T>() << width << ", seed " << seed;
  }
}

TEST(RelationalFunctions, AnyAndAll) {
  for_types<std::int8_t, std::int16_t, std::int32_t, std::int64_t>([]<class T>(T) {
    for (const std::uint32_t width : {1, 3, 16}) expect_any_and_all<T>(width);
  });
}

}  // namespace
}  // namespace warpgrain::profiler::builtins
