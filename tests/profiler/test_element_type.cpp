#include <cstring>
#include <gtest/gtest.h>
#include <sstream>
#include <vector>

#include "profiler/element_type.hpp"

namespace warpgrain::profiler {
namespace {

template <typename T>
std::optional<T> read(ElementType type, std::string_view text, bool hex = false) {
  T value{};
  if (!read_element(type, text, hex, reinterpret_cast<std::byte*>(&value))) return std::nullopt;
  return value;
}

template <typename T>
std::vector<T> range(ElementType type, std::vector<T> bounds, std::size_t n) {
  std::vector<T> values(n);
  if (!fill_range(type, std::as_bytes(std::span(bounds)), std::as_writable_bytes(std::span(values))))
    values.clear();
  return values;
}

TEST(ElementType, NamesWithAndWithoutVectorWidth) {
  EXPECT_EQ(element_type_of("float"), ElementType::f32);
  EXPECT_EQ(element_type_of("uchar16"), ElementType::u8);
  EXPECT_EQ(element_type_of("float5"), std::nullopt);
  EXPECT_EQ(element_type_of("half"), std::nullopt);
  EXPECT_EQ(element_type_of(""), std::nullopt);
  for (const std::string_view name : element_names())
    EXPECT_EQ(element_name(element_type_of(name).value()), name);
}

TEST(ElementType, TypesOfParameters) {
  EXPECT_EQ(element_type_of_parameter("float4*"), ElementType::f32);
  EXPECT_EQ(element_type_of_parameter("const ulong *"), ElementType::u64);
  EXPECT_EQ(element_type_of_parameter("int2"), ElementType::i32);
  EXPECT_EQ(element_type_of_parameter("void*"), ElementType::u8);
  EXPECT_EQ(element_type_of_parameter("struct Particle*"), std::nullopt);
}

TEST(ElementType, ReadsNumbersThatFit) {
  EXPECT_EQ(read<std::int8_t>(ElementType::i8, "-128"), -128);
  EXPECT_EQ(read<std::int8_t>(ElementType::i8, "128"), std::nullopt);
  EXPECT_EQ(read<std::uint8_t>(ElementType::u8, "255"), 255);
  EXPECT_EQ(read<std::uint8_t>(ElementType::u8, "256"), std::nullopt);
  EXPECT_EQ(read<std::uint32_t>(ElementType::u32, "-1"), 0xFFFFFFFFU);
  EXPECT_EQ(read<std::int64_t>(ElementType::i64, "-9223372036854775808"), INT64_MIN);
  EXPECT_EQ(read<std::int32_t>(ElementType::i32, "+7"), 7);
  EXPECT_EQ(read<std::int32_t>(ElementType::i32, "0x10"), std::nullopt);
  EXPECT_EQ(read<std::int32_t>(ElementType::i32, "0x10", true), 16);
  EXPECT_EQ(read<std::int32_t>(ElementType::i32, "ff", true), 255);
  EXPECT_EQ(read<std::int32_t>(ElementType::i32, "1.5"), std::nullopt);
  EXPECT_EQ(read<float>(ElementType::f32, "1e-3"), 1e-3F);
  EXPECT_EQ(read<double>(ElementType::f64, "-.5"), -0.5);
}

TEST(ElementType, RefusesWhatIsNoFiniteNumber) {
  for (const std::string_view text : {"nan", "inf", "-inf", "1e999", "", "x", "1x", "-"})
    EXPECT_EQ(read<float>(ElementType::f32, text), std::nullopt) << text;
}

TEST(ElementType, Ranges) {
  EXPECT_EQ(range<std::int32_t>(ElementType::i32, {0, 2, 6}, 4), (std::vector<std::int32_t>{0, 2, 4, 6}));
  EXPECT_EQ(range<std::int32_t>(ElementType::i32, {3, -1, 1}, 3), (std::vector<std::int32_t>{3, 2, 1}));
  EXPECT_EQ(range<float>(ElementType::f32, {1, 0.5F, 2}, 3), (std::vector<float>{1, 1.5F, 2}));
  EXPECT_EQ(range<float>(ElementType::f32, {0, 0.1F, 0.9F}, 10).size(), 10U);
  EXPECT_TRUE(range<std::int32_t>(ElementType::i32, {0, 2, 7}, 4).empty()) << "does not meet its end";
  EXPECT_TRUE(range<std::int32_t>(ElementType::i32, {0, 2, 6}, 5).empty()) << "too few for the size";
  EXPECT_TRUE(range<std::int32_t>(ElementType::i32, {0, 0, 0}, 1).empty()) << "a step of zero";
}

TEST(ElementType, DumpsAsOclgrindDoes) {
  const auto dumped = [](ElementType type, auto values, bool hex) {
    std::ostringstream out;
    dump_elements(type, "c", std::as_bytes(std::span(values)), hex, out);
    return out.str();
  };
  // Taken from oclgrind-kernel 21.10.
  EXPECT_EQ(dumped(ElementType::i32, std::vector<std::int32_t>{0, -7}, false), "  c[0] = 0\n  c[1] = -7\n");
  EXPECT_EQ(dumped(ElementType::i32, std::vector<std::int32_t>{19}, true), "  c[0] = 0x00000013\n");
  EXPECT_EQ(dumped(ElementType::i8, std::vector<std::int8_t>{0, -1}, true),
            "  c[0] = 0x00\n  c[1] = 0xffffffff\n");
  EXPECT_EQ(dumped(ElementType::u64, std::vector<std::uint64_t>{16}, true), "  c[0] = 0x0000000000000010\n");
  EXPECT_EQ(dumped(ElementType::f64, std::vector<double>{0.5, 1.0 / 3, 1e10}, false),
            "  c[0] = 0.5\n  c[1] = 0.333333\n  c[2] = 1e+10\n");
}

}  // namespace
}  // namespace warpgrain::profiler
