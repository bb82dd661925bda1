#include "reports/json_place.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fstream>
#include <iterator>
#include <limits>

#include "core/error.hpp"

namespace warpgrain::reports {
namespace {

constexpr std::size_t longest_quote = 60;  // characters of a wrong value that a message repeats

}  // namespace

std::string JsonPlace::child(std::string_view key) const {
  return fmt::format("{}{}{}", where_, is_root_ ? ": " : ".", key);
}

void JsonPlace::refuse(std::string_view expected) const {
  std::string found = value_->dump(-1, ' ', false, nlohmann::detail::error_handler_t::replace);
  if (found.size() > longest_quote) found = found.substr(0, longest_quote) + "...";
  throw_input_error(where_, found, expected);
}

std::optional<JsonPlace> JsonPlace::find(std::string_view key) const {
  if (!value_->is_object()) refuse("an object");
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return JsonPlace(*found, child(key), false);
}

JsonPlace JsonPlace::operator[](std::string_view key) const {
  if (auto found = find(key)) return *found;
  throw_input_error(child(key), "missing");
}

std::vector<JsonPlace> JsonPlace::elements() const {
  if (!value_->is_array()) refuse("an array");
  std::vector<JsonPlace> places;
  for (std::size_t k = 0; k < value_->size(); ++k)
    places.push_back(JsonPlace((*value_)[k], fmt::format("{}[{}]", where_, k), false));
  return places;
}

std::vector<std::pair<std::string, JsonPlace>> JsonPlace::members() const {
  if (!value_->is_object()) refuse("an object");
  std::vector<std::pair<std::string, JsonPlace>> places;
  for (const auto& [key, value] : value_->items())
    places.emplace_back(key, JsonPlace(value, child(key), false));
  return places;
}

std::uint64_t JsonPlace::count() const {
  if (!value_->is_number_unsigned()) refuse("a whole number, 0 or more");
  return value_->get<std::uint64_t>();
}

std::uint32_t JsonPlace::count32() const {
  const std::uint64_t value = count();
  if (value > std::numeric_limits<std::uint32_t>::max()) refuse("a whole number below 2^32");
  return static_cast<std::uint32_t>(value);
}

double JsonPlace::number() const {
  if (!value_->is_number()) refuse("a number");
  return value_->get<double>();
}

std::string JsonPlace::text() const {
  if (!value_->is_string()) refuse("a text");
  return value_->get<std::string>();
}

std::size_t JsonPlace::one_of(std::span<const std::string_view> names, std::string_view kind) const {
  const std::string name = text();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_unknown_name(where_, kind, name, names);
  return static_cast<std::size_t>(found - names.begin());
}

std::vector<std::uint64_t> JsonPlace::counts() const {
  std::vector<std::uint64_t> values;
  for (const JsonPlace& place : elements()) values.push_back(place.count());
  return values;
}

std::optional<std::string> JsonPlace::optional_text(std::string_view key) const {
  const auto place = find(key);
  return place ? std::optional(place->text()) : std::nullopt;
}

std::optional<std::uint64_t> JsonPlace::optional_count(std::string_view key) const {
  const auto place = find(key);
  return place ? std::optional(place->count()) : std::nullopt;
}

std::optional<double> JsonPlace::optional_number(std::string_view key) const {
  const auto place = find(key);
  return place ? std::optional(place->number()) : std::nullopt;
}

nlohmann::ordered_json read_json(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  if (!in) throw_input_error(file.string(), "cannot be read", "a JSON file");
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  if (in.bad()) throw_input_error(file.string(), "cannot be read to its end");
  try {
    return nlohmann::ordered_json::parse(text);
  } catch (const nlohmann::json::parse_error& e) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(std::min(e.byte, text.size()));
    throw_input_error(fmt::format("{}: line {}", file.string(), 1 + std::count(text.begin(), end, '\n')),
                      "not JSON");
  }
}

JsonPlace document_of_format(const nlohmann::ordered_json& document, std::string where,
                             std::string_view format) {
  JsonPlace root(document, std::move(where));
  const JsonPlace found = root["format"];
  if (found.text() != format) found.refuse(fmt::format("\"{}\"", format));
  return root;
}

}  // namespace warpgrain::reports
