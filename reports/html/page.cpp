#include "reports/html/page.hpp"

#include <algorithm>
#include <fmt/format.h>

#include "core/error.hpp"
#include "reports/html/page_scripts.hpp"

namespace warpgrain::reports::html {

std::string_view asset(std::string_view path) {
  const auto assets = page_assets();
  const auto found =
      std::find_if(assets.begin(), assets.end(), [&](const PageAsset& a) { return a.path == path; });
  if (found == assets.end()) throw_input_error(path, "not embedded", "a file of reports/html");
  return found->text;
}

std::string escape(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    switch (c) {
      case '&':
        escaped += "&amp;";
        break;
      case '<':
        escaped += "&lt;";
        break;
      case '>':
        escaped += "&gt;";
        break;
      case '"':
        escaped += "&quot;";
        break;
      case '\'':
        escaped += "&#39;";
        break;
      default:
        if (static_cast<unsigned char>(c) < 0x20 && c != '\t' && c != '\n')
          escaped += "\xEF\xBF\xBD";
        else
          escaped += c;
    }
  }
  return escaped;
}

std::string page(std::string_view title, std::string_view body) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\"/>\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n<title>{}</title>\n"
      "<style>\n{}</style>\n</head>\n<body>\n<main>\n{}</main>\n<script>\n{}{}</script>\n{}</body>\n</"
      "html>\n",
      escape(title), asset("html/page.css"), body, asset("html/sort.js"), asset("html/filter.js"),
      page_scripts(body));
}

}  // namespace warpgrain::reports::html
