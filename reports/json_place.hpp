#pragma once
// A value in a JSON document together with its place, so that whatever is wrong with it is refused in one
// line that names the place: "index.json: cases[3].status: missing". Seen only by the readers' sources.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace warpgrain::reports {

class JsonPlace {
 public:
  using Json = nlohmann::ordered_json;

  // The root of a document; `where` names it in messages. The document outlives the place.
  JsonPlace(const Json& value, std::string where)
      : value_(&value), where_(std::move(where)), is_root_(true) {}

  JsonPlace operator[](std::string_view key) const;                // InputError when missing
  std::optional<JsonPlace> find(std::string_view key) const;       // none when missing
  std::vector<JsonPlace> elements() const;                         // of an array
  std::vector<std::pair<std::string, JsonPlace>> members() const;  // of an object

  std::uint64_t count() const;  // an integer, 0 or more
  std::uint32_t count32() const;
  double number() const;
  std::string text() const;
  // The index of the text in `names`; another one is refused with the list of them.
  std::size_t one_of(std::span<const std::string_view> names, std::string_view kind) const;
  std::vector<std::uint64_t> counts() const;  // an array of them

  // The same where the key may be missing.
  std::optional<std::string> optional_text(std::string_view key) const;
  std::optional<std::uint64_t> optional_count(std::string_view key) const;
  std::optional<double> optional_number(std::string_view key) const;

  const std::string& where() const { return where_; }
  [[noreturn]] void refuse(std::string_view expected) const;

 private:
  JsonPlace(const Json& value, std::string where, bool is_root)
      : value_(&value), where_(std::move(where)), is_root_(is_root) {}
  std::string child(std::string_view key) const;

  const Json* value_;
  std::string where_;
  bool is_root_ = false;
};

// Reads and parses a file; InputError names the file, and the line when it is not JSON.
nlohmann::ordered_json read_json(const std::filesystem::path& file);

// The root of a document whose "format" must be `format`; another version, another format and none at all are
// each told apart in the message.
JsonPlace document_of_format(const nlohmann::ordered_json& document, std::string where,
                             std::string_view format);

}  // namespace warpgrain::reports
