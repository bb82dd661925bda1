#pragma once
// What the readers of the formats have in common. Seen only by their sources: the JSON library is slow to
// compile.

#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/json_reader.hpp"
#include "reports/generator.hpp"

namespace warpgrain::reports {

inline constexpr std::uintmax_t document_size_limit = std::uintmax_t{1} << 30;  // bytes

// The beginning of a document: {"format": ..., "generator": {...}, "command_line": ...}
nlohmann::ordered_json document_head(std::string_view format, const Generator& generator,
                                     const std::string& command_line);
Generator generator_from(const JsonReader& document);

// Reads a file whose "format" must be `format`. InputError names the file and the line that is not JSON, or
// the format that stands there instead.
JsonReader read_document(const std::filesystem::path& file, std::string_view format);

std::uint32_t whole_number32(const JsonReader& json);
std::vector<std::uint64_t> whole_numbers(const JsonReader& json);  // an array of them

// Keys that may be missing.
std::optional<std::string> optional_string(const JsonReader& json, std::string_view key);
std::optional<std::uint64_t> optional_whole_number(const JsonReader& json, std::string_view key);
std::optional<double> optional_number(const JsonReader& json, std::string_view key);

}  // namespace warpgrain::reports
