#pragma once
// The types of values in launch files: how they are written, filled, ranged and dumped, as Oclgrind does it.

#include <cstddef>
#include <cstdint>
#include <iosfwd>
#include <optional>
#include <span>
#include <string_view>

namespace warpgrain::profiler {

// char, uchar, short, ... double, in the order of element_names().
enum class ElementType : std::uint8_t { i8, u8, i16, u16, i32, u32, i64, u64, f32, f64 };

std::size_t element_size(ElementType type);
std::string_view element_name(ElementType type);
// Names of all types, in order of the enumeration.
std::span<const std::string_view> element_names();

// "float", and "float4", which is written as four floats; nullopt for other names.
std::optional<ElementType> element_type_of(std::string_view name);

// Of a parameter as a kernel's source declares it: "float4*", "const uint*", "int2"; "void*" counts as uchar.
// nullopt for structures and the like.
std::optional<ElementType> element_type_of_parameter(std::string_view declared);

// Bytes of an element of a parameter that points to vectors, as "float3*" and "float
// __attribute__((ext_vector_type(3)))*" do (16); 0 for others.
std::uint32_t vector_bytes_of_parameter(std::string_view declared);

// Writes the value that `text` spells to `to`, [element_size]. Whole numbers are decimal, or hexadecimal when
// `hex`, with or without 0x; a negative number for an unsigned type wraps around. False when the text is no
// finite number of the type.
bool read_element(ElementType type, std::string_view text, bool hex, std::byte* to);

// `begin`, `begin + step`, ... as far as they fill `to`. False when a step of zero or another number of
// values than reaches from `begin` to `end`, both included, is asked for. `bounds` are begin, step, end, as
// read_element wrote them.
bool fill_range(ElementType type, std::span<const std::byte> bounds, std::span<std::byte> to);

// One line an element: "  name[0] = 1".
void dump_elements(ElementType type, std::string_view name, std::span<const std::byte> data, bool hex,
                   std::ostream& out);

}  // namespace warpgrain::profiler
