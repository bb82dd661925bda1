#include "cli/bed.hpp"

#include <algorithm>
#include <cmath>
#include <fmt/format.h>
#include <numeric>

#include "core/candidate_census.hpp"
#include "reports/number_text.hpp"
#include "variants/searches.hpp"

namespace warpgrain::cli {
namespace {

constexpr double units_of_largest_side = 10000;

// Indices of the particles that are drawn, in the order of their places.
std::vector<std::size_t> drawn_particles(const ProfiledState& left, std::size_t axis, double middle,
                                         std::uint64_t most) {
  std::vector<std::size_t> drawn(left.particles.size());
  std::iota(drawn.begin(), drawn.end(), std::size_t{0});
  if (drawn.size() > most) {
    const auto distance = [&](std::size_t k) {
      return std::abs(left.particles.position[k][static_cast<Eigen::Index>(axis)] - middle);
    };
    std::ranges::nth_element(drawn, drawn.begin() + static_cast<std::ptrdiff_t>(most), {}, distance);
    drawn.resize(most);
  }
  std::ranges::sort(drawn, {}, [&](std::size_t k) { return left.places[k]; });
  return drawn;
}

void add_warps(reports::Bed& bed, const profiler::LaunchCounters& launch, const ProfiledState& left,
               std::span<const std::size_t> drawn) {
  bed.kernel = launch.kernel;
  const std::uint64_t local = launch.shape.local_size[0], width = launch.warp_width;
  for (const std::size_t k : drawn) {
    const std::uint64_t place = left.places[k];
    const std::uint64_t warp = place / local * ((local + width - 1) / width) + place % local / width;
    const profiler::WarpSums& sums = launch.warp_sums[warp];
    const double efficiency = static_cast<double>(sums.thread_instructions) /
                              static_cast<double>(std::max<std::uint64_t>(1, sums.warp_instructions * width));
    bed.warp.push_back(warp);
    bed.efficiency.push_back(std::round(1000 * efficiency) / 1000);
  }
}

}  // namespace

std::optional<reports::Bed> bed_of(const Scene& scene, const Variant& variant,
                                   std::span<const profiler::LaunchProfile> launches,
                                   const ProfiledState& left, std::uint64_t most) {
  const ParticleState& particles = left.particles;
  if (most == 0 || particles.size() == 0) return std::nullopt;
  Vector3d low = particles.position[0], high = low;
  for (std::size_t k = 0; k < particles.size(); ++k) {
    low = low.cwiseMin((particles.position[k].array() - particles.radius[k]).matrix());
    high = high.cwiseMax((particles.position[k].array() + particles.radius[k]).matrix());
  }
  const Vector3d sides = high - low;
  const std::size_t axis = sides[0] < sides[1] ? 0 : 1;
  const double middle = (low + high)[static_cast<Eigen::Index>(axis)] / 2;

  reports::Bed bed;
  bed.particles = particles.size();
  bed.unit = sides.maxCoeff() / units_of_largest_side;
  const auto in_units = [&](double length) { return std::llround(length / bed.unit); };
  for (std::size_t d = 0; d < 3; ++d) {
    bed.box[0][d] = in_units(low[static_cast<Eigen::Index>(d)]);
    bed.box[1][d] = in_units(high[static_cast<Eigen::Index>(d)]);
  }
  const std::vector<std::size_t> drawn = drawn_particles(left, axis, middle, most);
  if (drawn.size() < particles.size())
    bed.slab = fmt::format("the {} nearest to {} = {:.4g} m", reports::count_text(drawn.size()),
                           axis == 0 ? 'x' : 'y', middle);
  Scene now = scene;
  now.particles = particles;
  const NeighbourCounts counts = neighbour_counts(now);
  for (const std::size_t k : drawn) {
    bed.x.push_back(in_units(particles.position[k][0]));
    bed.y.push_back(in_units(particles.position[k][1]));
    bed.z.push_back(in_units(particles.position[k][2]));
    bed.radius.push_back(in_units(particles.radius[k]));
    bed.contacts.push_back(counts.contacts[k]);
    bed.candidates.push_back(counts.candidates[k]);
  }
  if (std::ranges::all_of(bed.radius, [&](std::int64_t radius) { return radius == bed.radius[0]; }))
    bed.radius.resize(1);
  const auto of_law = std::ranges::find_if(launches, [&](const profiler::LaunchProfile& launch) {
    return launch.counters.kernel == search_of(variant).law_kernel;
  });
  if (works_as_in_memory(variant) && of_law != launches.end()) add_warps(bed, of_law->counters, left, drawn);
  return bed;
}

}  // namespace warpgrain::cli
