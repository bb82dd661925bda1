#pragma once
// Results appear whole or not at all.

#include <filesystem>
#include <string_view>

namespace warpgrain::reports {

// Writes `content` to a temporary file beside `path` and renames it over `path`; missing folders are made. On
// any failure nothing of it stays behind, an older file at `path` is untouched, and InputError names the file
// and the system's reason.
void write_file_atomically(const std::filesystem::path& path, std::string_view content);

}  // namespace warpgrain::reports
