// vload and vstore (section 6.12.7) of every type and width in every address space, and shuffles (6.12.12).

#include <gtest/gtest.h>
#include <numeric>

#include "tests/profiler/builtins/scalar_types.hpp"
#include "tests/profiler/builtins/switch_program.hpp"
#include "tests/profiler/run_kernel.hpp"

namespace warpgrain::profiler::builtins {
namespace {

// Each work-item carries its vector from global through local and private memory, where it stands at odd
// places.
std::string carrying_program(std::string_view type) {
  std::string text = fmt::format(
      "constant {0} table[16] = {{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15}};\n"
      "kernel void carry(global {0}* to, global {0}* of_table, global const {0}* from, int width) {{\n"
      "  const size_t i = get_global_id(0);\n  local {0} shared[32 * 16 + 1];\n  {0} own[33];\n  switch "
      "(width) {{\n",
      type);
  for (const int n : {2, 3, 4, 8, 16})
    text += fmt::format(
        "    case {1}: {{\n      vstore{1}(vload{1}(i, from), get_local_id(0), shared + 1);\n"
        "      vstore{1}(vload{1}(get_local_id(0), shared + 1), 1, own + 1);\n"
        "      vstore{1}(vload{1}(1, own + 1), i, to);\n      vstore{1}(vload{1}(0, table + i % (17 - {1})), "
        "i, of_table);\n"
        "      break;\n    }}\n",
        type, n);
  return text + "  }\n}\n";
}

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
  return std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

template <class T>
void expect_carried() {
  Random random;
  std::vector<T> from(64 * 16);
  for (T& value : from) value = random_value<T>(random);
  const auto executable = compile_kernel(carrying_program(name_of<T>()), "carry", TraceMode::none);
  for (const int width : {2, 3, 4, 8, 16}) {
    std::vector<T> input(from.begin(), from.begin() + 64 * width), to(input.size()), of_table(input.size());
    run_launch(*executable, line_of(64, 32),
               {buffer_of(to), buffer_of(of_table), buffer_of(input), scalar_of(width)});
    EXPECT_TRUE(same_bits(to, input)) << name_of<T>() << width;
    for (std::size_t i = 0; i < of_table.size(); ++i) {
      const std::size_t item = i / width;
      ASSERT_EQ(of_table[i], static_cast<T>(item % (17 - width) + i % width)) << name_of<T>() << width;
    }
  }
}

TEST(VectorMemory, CarriesEveryTypeThroughEveryAddressSpace) {
  for_all_types([]<class T>(T) { expect_carried<T>(); });
}

// Indices count modulo the number of elements.
template <class T>
void expect_shuffled() {
  using Index = std::conditional_t<
      sizeof(T) == 1, std::uint8_t,
      std::conditional_t<sizeof(T) == 2, std::uint16_t,
                         std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;
  const std::string program = fmt::format(
      "kernel void mix(global {0}* one, global {0}* two, global const {0}* x, global const {0}* y,\n"
      "                global const {1}* at) {{\n  const size_t i = get_global_id(0);\n"
      "  vstore8(shuffle(vload4(i, x), vload8(i, at)), i, one);\n"
      "  vstore8(shuffle2(vload4(i, x), vload4(i, y), vload8(i, at)), i, two);\n}}\n",
      name_of<T>(), name_of<Index>());
  const auto executable = compile_kernel(program, "mix", TraceMode::none);
  Random random;
  std::vector<T> x(32 * 4), y(x.size()), one(32 * 8), two(one.size());
  std::vector<Index> at(one.size());
  std::iota(x.begin(), x.end(), T(0));
  std::iota(y.begin(), y.end(), T(100));
  for (Index& index : at) index = static_cast<Index>(random.bits());
  run_launch(*executable, line_of(32, 32),
             {buffer_of(one), buffer_of(two), buffer_of(x), buffer_of(y), buffer_of(at)});
  for (std::size_t i = 0; i < one.size(); ++i) {
    const std::size_t item = i / 8, of_two = at[i] % 8;
    ASSERT_EQ(one[i], x[item * 4 + at[i] % 4]) << name_of<T>() << ", seed " << seed;
    ASSERT_EQ(two[i], of_two < 4 ? x[item * 4 + of_two] : y[item * 4 + of_two - 4])
        << name_of<T>() << ", seed " << seed;
  }
}

TEST(VectorMemory, ShufflesEveryType) {
  for_all_types([]<class T>(T) { expect_shuffled<T>(); });
}

}  // namespace
}  // namespace warpgrain::profiler::builtins
