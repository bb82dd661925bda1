#pragma once
// JSON as this project writes it.

#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>

namespace warpgrain::reports {

// Indented text in the order of insertion, with everything that is short on a line of its own, and a newline
// at the end. The same value gives the same bytes. JSON has no NaN and no infinity: InputError names `where`
// and the place of a number that is not finite. Bytes that are not UTF-8 become the replacement character.
std::string json_text(const nlohmann::ordered_json& value, std::string_view where);

}  // namespace warpgrain::reports
