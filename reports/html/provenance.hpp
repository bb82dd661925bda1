#pragma once
// What stands at the end of a page: where its numbers come from.

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "reports/generator.hpp"

namespace warpgrain::reports::html {

using Provenance =
    std::vector<std::pair<std::string, std::string>>;  // name and text; empty texts are left out

// Of a fill; empty where a scene has none.
std::string seed_text(const std::optional<std::uint64_t>& seed);

// Heading and list; version, revision and command line come first.
std::string provenance(const Generator& generator, const std::string& command_line,
                       const Provenance& more = {});

}  // namespace warpgrain::reports::html
