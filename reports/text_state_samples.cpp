#include "reports/text_state_samples.hpp"

#include <fmt/format.h>

#include "reports/number_text.hpp"
#include "reports/text_table.hpp"

namespace warpgrain::reports {

std::string text_state_samples(std::span<const StateSample> samples) {
  if (samples.empty()) return {};
  const std::vector<std::string> kernels = heavy_kernels(samples);
  std::vector<TextTable::Column> columns{{"step"}, {"time"}, {"candidates"}, {"contacts"}};
  for (const std::string& kernel : kernels) columns.push_back({kernel});
  TextTable table(columns);
  for (const StateSample& sample : samples) {
    std::vector<std::string> row{
        count_text(sample.step), seconds_text(sample.time),
        fmt::format("{:.2f}, most {}", sample.mean_candidates, sample.most_candidates),
        fmt::format("{:.2f}, most {}", sample.mean_contacts, sample.most_contacts)};
    for (const std::string& name : kernels) {
      const StateSample::Kernel* const kernel = sample.kernel_named(name);
      row.push_back(kernel == nullptr ? "-" : fixed_text(kernel->simt_efficiency, 3));
    }
    table.add_row(row);
  }
  return "\nSIMT efficiency of each kernel from falling to rest; candidates and contacts a particle\n\n" +
         table.text();
}

}  // namespace warpgrain::reports
