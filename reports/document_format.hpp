#pragma once
// Of which format a document is.

#include <filesystem>
#include <string>

namespace warpgrain::reports {

// The document's "format", whatever it says. Throws InputError naming the file that is no JSON or has none.
std::string format_of(const std::filesystem::path& file);

}  // namespace warpgrain::reports
