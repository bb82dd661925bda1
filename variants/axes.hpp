#pragma once
// What can be varied. One table an axis; a variant is a value on every axis, and its name is the values
// joined with
// '/': branchy/cells/cell/fp32/default. Everything that lists, sweeps, tests or reports variants iterates
// these tables.

#include <array>
#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain {

struct AxisValue {
  std::string_view name;
  std::string_view summary;
};

struct Axis {
  std::string_view name;  // also the option: --contact
  std::string_view summary;
  std::size_t default_value;  // index into values
  std::span<const AxisValue> values;
};

// In the order of a variant's name.
std::span<const Axis> axes();
inline constexpr std::size_t n_axes = 5;
enum class AxisId : std::size_t { contact, search, order, precision, math };

class Variant {
 public:
  Variant();  // every axis at its default
  // Throws InputError that lists the valid names.
  static Variant parse(std::string_view name);
  void set(std::string_view axis, std::string_view value);

  std::string_view value(AxisId axis) const;
  std::string name() const;
  bool operator==(const Variant&) const = default;

 private:
  std::array<std::size_t, n_axes> index_{};
};

// Every combination that makes sense, in table order.
std::vector<Variant> all_variants();

}  // namespace warpgrain
