#include <fmt/format.h>

#include "reports/modelled_parts.hpp"
#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {

std::string text_modelled_parts(const ModelledParts& parts) {
  if (parts.features.empty()) return {};
  std::string left_out;
  for (const FeatureRow& row : parts.features)
    if (!row.modelled) left_out += fmt::format("{}{} ({})", left_out.empty() ? "" : ", ", row.name, row.why);
  std::string text = fmt::format("left out of the model: {}\n", left_out.empty() ? "nothing" : left_out);
  if (parts.device_bytes_per_particle)
    text +=
        fmt::format("device memory: {} bytes a particle\n", fixed_text(*parts.device_bytes_per_particle, 0));
  if (parts.against_full.empty()) return text;
  using enum TextTable::Align;
  TextTable table({{"cost", left}, {"here", right}, {"full model", right}, {"saved", right}});
  for (const Saving& saving : parts.against_full)
    table.add_row({saving.quantity, fmt::format("{:.4g}", saving.value), fmt::format("{:.4g}", saving.full),
                   saving.full == 0 ? "-" : percent_text(saving.full - saving.value, saving.full)});
  text += "\n" + table.text();
  if (parts.position_difference)
    text += fmt::format("particles end within {:.3g} m of where the full model takes them\n",
                        *parts.position_difference);
  return text;
}

}  // namespace warpgrain::reports
