#include "profiler/ptx/modifier_reader.hpp"

#include <algorithm>

namespace warpgrain::profiler::ptx {

std::string_view ModifierReader::take_one_of(std::initializer_list<std::string_view> names) {
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i] || std::find(names.begin(), names.end(), statement_.modifiers[i]) == names.end()) continue;
    taken_[i] = true;
    return statement_.modifiers[i];
  }
  return {};
}

std::optional<ScalarType> ModifierReader::take_type() {
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i]) continue;
    if (const auto type = scalar_type(statement_.modifiers[i])) {
      taken_[i] = true;
      return type;
    }
  }
  return std::nullopt;
}

std::optional<StateSpace> ModifierReader::take_space() {
  for (std::size_t i = 0; i < taken_.size(); ++i) {
    if (taken_[i]) continue;
    if (const auto space = state_space(statement_.modifiers[i])) {
      taken_[i] = true;
      return space;
    }
  }
  return std::nullopt;
}

void ModifierReader::drop_prefixed(std::string_view prefix) {
  for (std::size_t i = 0; i < taken_.size(); ++i)
    if (statement_.modifiers[i].starts_with(prefix)) taken_[i] = true;
}

std::string_view ModifierReader::left_over() const {
  for (std::size_t i = 0; i < taken_.size(); ++i)
    if (!taken_[i]) return statement_.modifiers[i];
  return {};
}

}  // namespace warpgrain::profiler::ptx
