#pragma once
// A JSON document read strictly: every access knows its place in the file and refuses what is not expected
// there with one line, "FILE: walls[2].rectangle.edges[0]: what; expected ...". For readers of the project's
// own formats; include in .cpp files only, the JSON library is slow to compile.

#include <array>
#include <initializer_list>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector3.hpp"

namespace warpgrain {

class JsonReader {
 public:
  // Throws InputError with line and column where the text is no JSON, a key stands twice or a number
  // overflows.
  static JsonReader parse(std::string_view text, std::string_view file);

  // "FILE: path"
  std::string where() const;
  const std::string& file() const { return *file_; }
  [[noreturn]] void fail(std::string_view what, std::string_view expected) const;

  // An object with no keys but these; the others fail naming the valid ones.
  void require_keys(std::span<const std::string_view> allowed) const;
  void require_keys(std::initializer_list<std::string_view> allowed) const {
    require_keys(std::span(allowed.begin(), allowed.size()));
  }
  bool has(std::string_view key) const;
  JsonReader at(std::string_view key) const;                    // fails when it is missing
  std::optional<JsonReader> maybe(std::string_view key) const;  // empty when it is missing
  std::vector<std::string> keys() const;                        // of an object
  bool is_array() const { return value_->is_array(); }
  bool is_string() const { return value_->is_string(); }
  std::vector<JsonReader> elements() const;  // of an array
  std::vector<JsonReader> elements(std::size_t n, std::string_view expected) const;

  std::string string() const;
  bool boolean() const;
  double number() const;  // finite
  double number_above(double bound) const;
  double number_at_least(double bound) const;
  std::uint64_t count() const;  // a whole number of at least 1
  std::uint64_t whole_number() const;
  Vector3d vector() const;  // three finite numbers
  // The index of the string in `names`; another one fails naming them all.
  std::size_t one_of(std::span<const std::string_view> names, std::string_view kind) const;

 private:
  JsonReader(std::shared_ptr<const nlohmann::json> root, const nlohmann::json* value,
             std::shared_ptr<const std::string> file, std::string path)
      : root_(std::move(root)), value_(value), file_(std::move(file)), path_(std::move(path)) {}
  JsonReader child(const nlohmann::json& value, std::string path) const {
    return {root_, &value, file_, std::move(path)};
  }
  std::string quoted() const;  // the value, short enough for a line

  std::shared_ptr<const nlohmann::json> root_;
  const nlohmann::json* value_;
  std::shared_ptr<const std::string> file_;
  std::string path_;
};

}  // namespace warpgrain
