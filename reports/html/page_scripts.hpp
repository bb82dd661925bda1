#pragma once
// The scripts that what is on a page asks for.

#include <string>
#include <string_view>

namespace warpgrain::reports::html {

// Those that draw the charts, timelines and beds of `body`, for the end of the page; empty where it has none.
std::string page_scripts(std::string_view body);

}  // namespace warpgrain::reports::html
