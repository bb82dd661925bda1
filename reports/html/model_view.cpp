#include <fmt/format.h>

#include "reports/html/page.hpp"
#include "reports/html/table.hpp"
#include "reports/html/views.hpp"

namespace warpgrain::reports::html {

std::string model_view(const ModelledParts& parts) {
  if (parts.features.empty()) return {};
  Table features({{"part of the model", "what a scene may do without", true},
                  {"in the kernels", "whether the kernels were compiled with it", true},
                  {"needed", "whether the scene needs it", true},
                  {"why", "what of the scene asks for it, or does not", true}});
  for (const FeatureRow& row : parts.features)
    features.add_row({text_cell(row.name), text_cell(row.modelled ? "yes" : "left out"),
                      text_cell(row.needed ? "yes" : "no"), text_cell(row.why)});
  std::string html = "<h2>What is modelled</h2>\n" + features.html();
  if (parts.device_bytes_per_particle)
    html += fmt::format("<p>Device memory: {:.0f} bytes a particle.</p>\n", *parts.device_bytes_per_particle);
  if (parts.against_full.empty()) return html;
  Table savings({{"a particle and step", "what is counted of each", true},
                 {"here", "with the parts that are left in"},
                 {"full model", "with all parts"},
                 {"saved", "of the full model's"}});
  for (const Saving& saving : parts.against_full)
    savings.add_row({text_cell(saving.quantity), number_cell(saving.value, 2), number_cell(saving.full, 2),
                     share_cell(saving.full - saving.value, saving.full)});
  return html + savings.html();
}

}  // namespace warpgrain::reports::html
