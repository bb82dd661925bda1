#pragma once
// The frame of a page: one file that needs nothing else. Style and script are the files of this folder,
// embedded at build time. Pages are well-formed XML too, so that any parser can check them.

#include <span>
#include <string>
#include <string_view>

namespace warpgrain::reports::html {

struct PageAsset {
  std::string_view path;  // "html/page.css"
  std::string_view text;
};
std::span<const PageAsset> page_assets();

// The text of one; throws InputError where it was not embedded.
std::string_view asset(std::string_view path);

// Text as it may stand between tags and in quoted attributes. Control characters become the replacement
// character.
std::string escape(std::string_view text);

// A whole page; `body` is HTML.
std::string page(std::string_view title, std::string_view body);

}  // namespace warpgrain::reports::html
