#pragma once
// Whole files, read with a limit and written so that nobody ever sees a half.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace warpgrain {

// Throws InputError naming the file when it is not there, no plain file, not readable or larger than `limit`
// [bytes].
std::string read_text_file(const std::filesystem::path& path, std::uintmax_t limit);

// Writes to a neighbour of `path` and renames it there. Throws InputError, leaving no file behind, when that
// fails.
void write_file_atomically(const std::filesystem::path& path, std::string_view text);

}  // namespace warpgrain
