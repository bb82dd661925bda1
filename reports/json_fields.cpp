#include "reports/json_fields.hpp"

#include <fmt/format.h>
#include <limits>

#include "core/file_io.hpp"

namespace warpgrain::reports {

nlohmann::ordered_json document_head(std::string_view format, const Generator& generator,
                                     const std::string& command_line) {
  return {{"format", format},
          {"generator", {{"version", generator.version}, {"git_revision", generator.git_revision}}},
          {"command_line", command_line}};
}

Generator generator_from(const JsonReader& document) {
  const JsonReader generator = document.at("generator");
  return {generator.at("version").string(), generator.at("git_revision").string()};
}

JsonReader read_document(const std::filesystem::path& file, std::string_view format) {
  JsonReader document = JsonReader::parse(read_text_file(file, document_size_limit), file.string());
  const JsonReader found = document.at("format");
  if (found.string() != format) found.fail(fmt::format("'{}'", found.string()), fmt::format("'{}'", format));
  return document;
}

std::uint32_t whole_number32(const JsonReader& json) {
  const std::uint64_t value = json.whole_number();
  if (value > std::numeric_limits<std::uint32_t>::max())
    json.fail(fmt::format("{}", value), "less than 2^32");
  return static_cast<std::uint32_t>(value);
}

std::vector<std::uint64_t> whole_numbers(const JsonReader& json) {
  std::vector<std::uint64_t> values;
  for (const JsonReader& element : json.elements()) values.push_back(element.whole_number());
  return values;
}

std::optional<std::string> optional_string(const JsonReader& json, std::string_view key) {
  const auto found = json.maybe(key);
  return found ? std::optional(found->string()) : std::nullopt;
}

std::optional<std::uint64_t> optional_whole_number(const JsonReader& json, std::string_view key) {
  const auto found = json.maybe(key);
  return found ? std::optional(found->whole_number()) : std::nullopt;
}

std::optional<double> optional_number(const JsonReader& json, std::string_view key) {
  const auto found = json.maybe(key);
  return found ? std::optional(found->number()) : std::nullopt;
}

}  // namespace warpgrain::reports
