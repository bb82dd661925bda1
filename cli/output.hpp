#pragma once
// Where a command's results go, and how it was called.

#include <filesystem>
#include <string>
#include <string_view>

namespace warpgrain::cli {

// Writes `text` to stdout when `target` is "-", else to that file, whole or not at all, making its folder.
// Throws InputError when the file cannot be written.
void write_output(const std::string& target, std::string_view text);

// Makes the folder and those above it. Throws InputError when that cannot be.
void make_folder(const std::filesystem::path& folder);

// The call of this process, quoted so that a shell takes it again: part of every document's provenance.
const std::string& command_line();
void set_command_line(int argc, const char* const* argv);

// Throws InputError unless the document was made by this call, --resume aside: what it holds may stand beside
// what this call adds.
void require_same_call(const std::string& file, std::string_view command_line_of_document);

}  // namespace warpgrain::cli
