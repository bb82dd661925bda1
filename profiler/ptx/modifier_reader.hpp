#pragma once
// The modifiers of one instruction, taken one by one: what nobody took is an instruction that is not carried,
// never one silently run as another.

#include <initializer_list>
#include <optional>
#include <string_view>
#include <vector>

#include "profiler/ptx/module.hpp"

namespace warpgrain::profiler::ptx {

class ModifierReader {
 public:
  explicit ModifierReader(const Statement& statement)
      : statement_(statement), taken_(statement.modifiers.size(), false) {}

  bool take(std::string_view name) { return !take_one_of({name}).empty(); }
  // The first of these that stands there, or an empty text.
  std::string_view take_one_of(std::initializer_list<std::string_view> names);
  // The first scalar type that is left.
  std::optional<ScalarType> take_type();
  // The first state space that is left.
  std::optional<StateSpace> take_space();
  // Drops modifiers that begin so, cache hints for one.
  void drop_prefixed(std::string_view prefix);
  // The first that nobody took, or an empty text.
  std::string_view left_over() const;

 private:
  const Statement& statement_;
  std::vector<bool> taken_;
};

}  // namespace warpgrain::profiler::ptx
