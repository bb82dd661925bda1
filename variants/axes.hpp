#pragma once
// What can be varied. One table an axis; a variant is a value on every axis. Its name is the values of the
// first axes joined with '/', then those of the tuning axes that are not at their default:
// branchy/cells/cell/fp32/default, branchy/cells/cell/fp32/default/sort=counting. Everything that lists,
// sweeps, tests or reports variants iterates these tables; variants/combinations.hpp says which go together.

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
  bool is_tuning = false;
};

// In the order of a variant's name.
std::span<const Axis> axes();
inline constexpr std::size_t n_axes = 11;
// Throws InputError that lists the valid names.
const Axis& axis_named(std::string_view name);
enum class AxisId : std::size_t {
  contact,
  search,
  order,
  precision,
  math,
  sort,
  cell_size,
  work_group_size,
  reorder_every,
  model,
  denormals
};

class Variant {
 public:
  Variant();  // every axis at its default
  // Throws InputError that lists the valid names. Whether the values go together is not asked.
  static Variant parse(std::string_view name);
  void set(std::string_view axis, std::string_view value);

  std::string_view value(AxisId axis) const;
  std::string name() const;
  bool operator==(const Variant&) const = default;

 private:
  std::array<std::size_t, n_axes> index_{};
};

}  // namespace warpgrain
