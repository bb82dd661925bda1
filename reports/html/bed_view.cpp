#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/bed_json.hpp"
#include "reports/html/page.hpp"
#include "reports/html/views.hpp"
#include "reports/number_text.hpp"

namespace warpgrain::reports::html {

std::string bed_view(const Report& report) {
  if (!report.bed) return {};
  const Bed& bed = *report.bed;
  std::string introduction =
      bed.slab.empty()
          ? fmt::format("All {} particles after the step.", count_text(bed.particles))
          : fmt::format("Of {} particles {}, after the step.", count_text(bed.particles), bed.slab);
  introduction +=
      bed.kernel.empty()
          ? " The search of this variant has no work-item for each particle, so that particles have no warp."
          : fmt::format(
                " A particle's warp is the one of {} that has it; its SIMT efficiency is counted over the "
                "instructions of the PTX.",
                bed.kernel);
  return fmt::format(
      "<h2>The bed</h2>\n<p class=\"soft\">{}</p>\n<div class=\"bed\" data-bed=\"{}\"></div>\n",
      escape(introduction), escape(to_json(bed).dump()));
}

}  // namespace warpgrain::reports::html
