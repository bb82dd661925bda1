#include "reports/html/provenance.hpp"

#include <fmt/format.h>

#include "reports/html/page.hpp"

namespace warpgrain::reports::html {

std::string seed_text(const std::optional<std::uint64_t>& seed) {
  return seed ? fmt::format("{}", *seed) : std::string();
}

std::string provenance(const Generator& generator, const std::string& command_line, const Provenance& more) {
  Provenance all{{"warpgrain", fmt::format("{}, revision {}", generator.version, generator.git_revision)},
                 {"command", command_line}};
  all.insert(all.end(), more.begin(), more.end());
  std::string html = "<h2>Where these numbers come from</h2>\n<dl class=\"provenance\">\n";
  for (const auto& [name, text] : all)
    if (!text.empty())
      html += fmt::format("<dt>{}</dt><dd><code>{}</code></dd>\n", escape(name), escape(text));
  return html + "</dl>\n";
}

}  // namespace warpgrain::reports::html
