#include "core/json_reader.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <set>

#include "core/error.hpp"

namespace warpgrain {
namespace {

// "line L, column C" of the byte before `position`, which is where the library's count ends.
std::string line_and_column(std::string_view text, std::size_t position) {
  const std::string_view read = text.substr(0, position > 0 ? position - 1 : 0);
  const auto line = std::count(read.begin(), read.end(), '\n') + 1;
  const std::size_t line_start = read.rfind('\n') == std::string_view::npos ? 0 : read.rfind('\n') + 1;
  return fmt::format("line {}, column {}", line, read.size() - line_start + 1);
}

// What the library lets pass: of two equal keys it keeps the last, and a reader would wonder why the first
// has no effect; and it nests without end, which recursion over the document would not survive.
class Watch {
 public:
  explicit Watch(std::string_view file) : file_(file) {}
  bool operator()(int depth, nlohmann::json::parse_event_t event, nlohmann::json& parsed) {
    constexpr int deepest = 64;
    if (depth > deepest)
      throw_input_error(file_, "nested too deeply", fmt::format("at most {} levels", deepest));
    if (event == nlohmann::json::parse_event_t::object_start) {
      keys_.resize(static_cast<std::size_t>(depth) + 1);
      keys_.back().clear();
    } else if (event == nlohmann::json::parse_event_t::key) {
      const auto key = parsed.get<std::string>();
      if (!keys_[static_cast<std::size_t>(depth) - 1].insert(key).second)
        throw_input_error(file_, fmt::format("key '{}' twice in one object", key), "it once");
    }
    return true;
  }

 private:
  std::string_view file_;
  std::vector<std::set<std::string>> keys_;  // of the open objects, by depth
};

}  // namespace

JsonReader JsonReader::parse(std::string_view text, std::string_view file) {
  try {
    auto root =
        std::make_shared<const nlohmann::json>(nlohmann::json::parse(text.begin(), text.end(), Watch(file)));
    const nlohmann::json* value = root.get();
    return {std::move(root), value, std::make_shared<const std::string>(file), ""};
  } catch (const nlohmann::json::parse_error& e) {
    // "[json.exception.parse_error.101] parse error at line 2, column 5: syntax error while ..."
    std::string message = e.what();
    const std::size_t cause = message.find(": ");
    if (cause != std::string::npos) message.erase(0, cause + 2);
    throw_input_error(fmt::format("{}: {}", file, line_and_column(text, e.byte)), message);
  } catch (const nlohmann::json::exception& e) {
    std::string message = e.what();
    throw_input_error(file, message.substr(message.find("] ") + 2), "JSON with numbers that fit a double");
  }
}

std::string JsonReader::where() const { return path_.empty() ? *file_ : *file_ + ": " + path_; }

void JsonReader::fail(std::string_view what, std::string_view expected) const {
  throw_input_error(where(), what, expected);
}

std::string JsonReader::quoted() const {
  constexpr std::size_t longest = 60;
  std::string text = value_->dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  if (text.size() > longest) text = text.substr(0, longest) + "...";
  return text;
}

void JsonReader::require_keys(std::span<const std::string_view> allowed) const {
  if (!value_->is_object()) fail(quoted(), "an object");
  for (const auto& [key, unused] : value_->items())
    if (std::find(allowed.begin(), allowed.end(), key) == allowed.end())
      throw_unknown_name(where(), "key", key, allowed);
}

bool JsonReader::has(std::string_view key) const { return value_->contains(key); }

JsonReader JsonReader::at(std::string_view key) const {
  if (auto found = maybe(key)) return *found;
  fail(fmt::format("'{}' is missing", key), "an object that has it");
}

std::optional<JsonReader> JsonReader::maybe(std::string_view key) const {
  const auto found = value_->find(key);
  if (found == value_->end()) return std::nullopt;
  return child(*found, path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key));
}

std::vector<std::string> JsonReader::keys() const {
  if (!value_->is_object()) fail(quoted(), "an object");
  std::vector<std::string> keys;
  for (const auto& [key, unused] : value_->items()) keys.push_back(key);
  return keys;
}

std::vector<JsonReader> JsonReader::elements() const {
  if (!value_->is_array()) fail(quoted(), "an array");
  std::vector<JsonReader> result;
  for (std::size_t k = 0; k < value_->size(); ++k)
    result.push_back(child((*value_)[k], fmt::format("{}[{}]", path_, k)));
  return result;
}

std::vector<JsonReader> JsonReader::elements(std::size_t n, std::string_view expected) const {
  if (!value_->is_array() || value_->size() != n) fail(quoted(), expected);
  return elements();
}

bool JsonReader::boolean() const {
  if (!value_->is_boolean()) fail(quoted(), "true or false");
  return value_->get<bool>();
}

std::string JsonReader::string() const {
  if (!value_->is_string()) fail(quoted(), "a string");
  return value_->get<std::string>();
}

double JsonReader::number() const {
  if (!value_->is_number()) fail(quoted(), "a number");
  const double number = value_->get<double>();
  if (!std::isfinite(number)) fail(quoted(), "a finite number");
  return number;
}

double JsonReader::number_above(double bound) const {
  const double result = number();
  if (!(result > bound)) fail(quoted(), fmt::format("a number above {}", bound));
  return result;
}

double JsonReader::number_at_least(double bound) const {
  const double result = number();
  if (!(result >= bound)) fail(quoted(), fmt::format("a number of at least {}", bound));
  return result;
}

std::uint64_t JsonReader::whole_number() const {
  if (!value_->is_number_unsigned()) fail(quoted(), "a whole number");
  return value_->get<std::uint64_t>();
}

std::uint64_t JsonReader::count() const {
  if (!value_->is_number_unsigned() || value_->get<std::uint64_t>() == 0)
    fail(quoted(), "a whole number of at least 1");
  return value_->get<std::uint64_t>();
}

Vector3d JsonReader::vector() const {
  const auto parts = elements(3, "three numbers");
  return {parts[0].number(), parts[1].number(), parts[2].number()};
}

std::size_t JsonReader::one_of(std::span<const std::string_view> names, std::string_view kind) const {
  const std::string name = string();
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end()) throw_unknown_name(where(), kind, name, names);
  return static_cast<std::size_t>(found - names.begin());
}

}  // namespace warpgrain
