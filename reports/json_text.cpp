#include "reports/json_text.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

using Json = nlohmann::ordered_json;
constexpr std::size_t line_width = 120;

void require_finite(const Json& value, const std::string& place) {
  if (value.is_number_float() && !std::isfinite(value.get<double>()))
    throw_input_error(place, fmt::format("'{}'", value.get<double>()), "a finite number");
  if (value.is_object())
    for (const auto& [key, child] : value.items()) require_finite(child, place + "." + key);
  if (value.is_array())
    for (std::size_t k = 0; k < value.size(); ++k) require_finite(value[k], fmt::format("{}[{}]", place, k));
}

std::string one_line(const Json& value) {
  return value.dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
}

bool has_only_scalars(const Json& value) {
  return std::none_of(value.begin(), value.end(), [](const Json& child) { return child.is_structured(); });
}

bool has_only_numbers(const Json& value) {
  return value.is_array() &&
         std::all_of(value.begin(), value.end(), [](const Json& child) { return child.is_number(); });
}

void append(std::string& text, const Json& value, std::size_t indent) {
  if (!value.is_structured() || has_only_numbers(value)) {
    text += one_line(value);
    return;
  }
  if (has_only_scalars(value)) {
    const std::string line = one_line(value);
    if (indent + line.size() <= line_width) {
      text += line;
      return;
    }
  }
  const std::string margin(indent + 1, ' ');
  text += value.is_object() ? "{" : "[";
  bool first = true;
  for (const auto& [key, child] : value.items()) {
    text += first ? "\n" : ",\n";
    first = false;
    text += margin;
    if (value.is_object()) text += one_line(Json(key)) + ": ";
    append(text, child, indent + 1);
  }
  text += '\n';
  text.append(indent, ' ');
  text += value.is_object() ? '}' : ']';
}

}  // namespace

std::string json_text(const Json& value, std::string_view where) {
  require_finite(value, std::string(where));
  std::string text;
  append(text, value, 0);
  return text + "\n";
}

}  // namespace warpgrain::reports
