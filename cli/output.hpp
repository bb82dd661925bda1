#pragma once
// Where a command's results go.

#include <string>
#include <string_view>

namespace warpgrain::cli {

// Writes `text` to stdout when `target` is "-", else to that file, whole or not at all. Throws InputError
// when the file cannot be written.
void write_output(const std::string& target, std::string_view text);

}  // namespace warpgrain::cli
