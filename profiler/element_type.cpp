#include "profiler/element_type.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstring>
#include <fmt/format.h>
#include <iomanip>
#include <ostream>
#include <type_traits>

namespace warpgrain::profiler {
namespace {

constexpr std::array<std::string_view, 10> type_names{"char", "uchar", "short", "ushort", "int",
                                                      "uint", "long",  "ulong", "float",  "double"};

// Calls `function` with a value of the C++ type that stands for `type`.
template <typename Function>
auto with_type(ElementType type, Function&& function) {
  switch (type) {
    case ElementType::i8:
      return function(std::int8_t{});
    case ElementType::u8:
      return function(std::uint8_t{});
    case ElementType::i16:
      return function(std::int16_t{});
    case ElementType::u16:
      return function(std::uint16_t{});
    case ElementType::i32:
      return function(std::int32_t{});
    case ElementType::u32:
      return function(std::uint32_t{});
    case ElementType::i64:
      return function(std::int64_t{});
    case ElementType::u64:
      return function(std::uint64_t{});
    case ElementType::f32:
      return function(float{});
    case ElementType::f64:
      break;
  }
  return function(double{});
}

template <typename T>
bool read(std::string_view text, bool hex, T& value) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const char* const end = text.data() + text.size();
  if constexpr (std::is_floating_point_v<T>) {
    const auto result = std::from_chars(text.data(), end, value);
    return result.ec == std::errc{} && result.ptr == end && std::isfinite(value);
  } else {
    const bool negative = text.starts_with('-');
    if (negative) text.remove_prefix(1);
    if (hex && (text.starts_with("0x") || text.starts_with("0X"))) text.remove_prefix(2);
    std::uint64_t magnitude = 0;
    const auto result = std::from_chars(text.data(), end, magnitude, hex ? 16 : 10);
    if (result.ec != std::errc{} || result.ptr != end) return false;
    const std::uint64_t most = static_cast<std::uint64_t>(std::numeric_limits<T>::max());
    if (magnitude > most + (negative && std::is_signed_v<T> ? 1 : 0)) return false;
    value = static_cast<T>(negative ? ~magnitude + 1 : magnitude);
    return true;
  }
}

template <typename T>
T element_at(std::span<const std::byte> data, std::size_t i) {
  T value;
  std::memcpy(&value, data.data() + i * sizeof(T), sizeof(T));
  return value;
}

}  // namespace

std::size_t element_size(ElementType type) {
  return with_type(type, [](auto value) { return sizeof value; });
}

std::string_view element_name(ElementType type) { return type_names[static_cast<std::size_t>(type)]; }

std::span<const std::string_view> element_names() { return type_names; }

std::optional<ElementType> element_type_of(std::string_view name) {
  const std::size_t digits = name.find_first_of("0123456789");
  const std::string_view width = digits == std::string_view::npos ? "2" : name.substr(digits);
  constexpr std::array<std::string_view, 5> widths{"2", "3", "4", "8", "16"};
  const auto found = std::find(type_names.begin(), type_names.end(), name.substr(0, digits));
  if (found == type_names.end() || std::find(widths.begin(), widths.end(), width) == widths.end())
    return std::nullopt;
  return static_cast<ElementType>(found - type_names.begin());
}

std::optional<ElementType> element_type_of_parameter(std::string_view declared) {
  for (const std::string_view qualifier : {"const ", "volatile ", "restrict "})
    if (declared.starts_with(qualifier)) return element_type_of_parameter(declared.substr(qualifier.size()));
  const std::string_view base = declared.substr(0, declared.find_first_of(" *"));
  if (base == "void" && declared.ends_with('*')) return ElementType::u8;
  return element_type_of(base);
}

std::uint32_t vector_bytes_of_parameter(std::string_view declared) {
  for (const std::string_view qualifier : {"const ", "volatile ", "restrict "})
    if (declared.starts_with(qualifier)) return vector_bytes_of_parameter(declared.substr(qualifier.size()));
  const auto type = element_type_of_parameter(declared);
  if (!type || !declared.ends_with('*')) return 0;
  // "float4*", or as clang resolves the name.
  constexpr std::string_view attribute = "ext_vector_type(";
  std::size_t digits = declared.find(attribute);
  digits =
      digits == std::string_view::npos ? declared.find_first_of("0123456789") : digits + attribute.size();
  if (digits == std::string_view::npos) return 0;
  std::uint32_t width = 0;
  std::from_chars(declared.data() + digits, declared.data() + declared.size(), width);
  return static_cast<std::uint32_t>(element_size(*type)) * std::bit_ceil(width);
}

bool read_element(ElementType type, std::string_view text, bool hex, std::byte* to) {
  return with_type(type, [&](auto value) {
    if (!read(text, hex, value)) return false;
    std::memcpy(to, &value, sizeof value);
    return true;
  });
}

bool fill_range(ElementType type, std::span<const std::byte> bounds, std::span<std::byte> to) {
  return with_type(type, [&](auto value) {
    using T = decltype(value);
    const T begin = element_at<T>(bounds, 0), step = element_at<T>(bounds, 1), end = element_at<T>(bounds, 2);
    if (step == T{}) return false;
    // Half a step of slack, since a sum of rounded steps does not meet the end of a range of fractions
    // exactly.
    const double count =
        std::floor((static_cast<double>(end) - static_cast<double>(begin)) / static_cast<double>(step) + 1.5);
    const double last = static_cast<double>(begin) + (count - 1) * static_cast<double>(step);
    const bool meets_end =
        std::abs(last - static_cast<double>(end)) <= 1e-4 * std::abs(static_cast<double>(step));
    if (!meets_end || count * sizeof(T) != static_cast<double>(to.size())) return false;
    value = begin;
    for (std::size_t i = 0; i < to.size() / sizeof(T); ++i, value = static_cast<T>(value + step))
      std::memcpy(to.data() + i * sizeof(T), &value, sizeof value);
    return true;
  });
}

void dump_elements(ElementType type, std::string_view name, std::span<const std::byte> data, bool hex,
                   std::ostream& out) {
  with_type(type, [&](auto value) {
    using T = decltype(value);
    for (std::size_t i = 0; i < data.size() / sizeof(T); ++i) {
      out << "  " << name << '[' << i << "] = ";
      // Floating-point numbers keep their decimal digits behind the 0x, and bytes are printed as ints:
      // Oclgrind's way.
      if (hex) out << "0x" << std::setfill('0') << std::setw(2 * sizeof(T)) << std::hex;
      if constexpr (sizeof(T) == 1) {
        out << static_cast<int>(element_at<T>(data, i));
      } else {
        out << element_at<T>(data, i);
      }
      out << std::dec << '\n';
    }
  });
}

}  // namespace warpgrain::profiler
