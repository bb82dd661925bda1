#pragma once
// The scalar types and state spaces of PTX.

#include <cstdint>
#include <optional>
#include <string_view>

namespace warpgrain::profiler::ptx {

struct ScalarType {
  enum class Kind : std::uint8_t { bits, unsigned_integer, signed_integer, floating, predicate };
  Kind kind = Kind::bits;
  std::uint8_t bits = 0;

  bool is_float() const { return kind == Kind::floating; }
  bool is_signed() const { return kind == Kind::signed_integer; }
  bool is_predicate() const { return kind == Kind::predicate; }
  std::uint32_t bytes() const { return (bits + 7u) / 8u; }
  bool operator==(const ScalarType&) const = default;
};

inline constexpr ScalarType predicate_type{ScalarType::Kind::predicate, 1};
constexpr ScalarType bits_type(std::uint8_t bits) { return {ScalarType::Kind::bits, bits}; }

// "u32", "pred", ...; nothing for any other name.
std::optional<ScalarType> scalar_type(std::string_view name);

enum class StateSpace : std::uint8_t { generic, global, shared, constant, local, parameter };

// "global", "const", "shared::cta", ...; nothing for any other name.
std::optional<StateSpace> state_space(std::string_view name);

}  // namespace warpgrain::profiler::ptx
