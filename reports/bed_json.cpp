#include "reports/bed_json.hpp"

#include <cmath>
#include <fmt/format.h>
#include <limits>
#include <nlohmann/json.hpp>

#include "reports/json_fields.hpp"

namespace warpgrain::reports {
namespace {

using BedJson = nlohmann::ordered_json;

std::vector<std::int64_t> lengths_from(const JsonReader& place) {
  std::vector<std::int64_t> lengths;
  for (const JsonReader& element : place.elements()) {
    const double length = element.number();
    if (std::abs(length) > 1e9 || length != std::floor(length))
      element.fail(fmt::format("{}", length), "a whole number of units");
    lengths.push_back(static_cast<std::int64_t>(length));
  }
  return lengths;
}

}  // namespace

BedJson to_json(const Bed& bed) {
  BedJson json{{"particles", bed.particles}, {"unit", bed.unit}};
  if (!bed.slab.empty()) json["slab"] = bed.slab;
  if (!bed.kernel.empty()) json["kernel"] = bed.kernel;
  json["box"] = bed.box;
  json["x"] = bed.x;
  json["y"] = bed.y;
  json["z"] = bed.z;
  json["radius"] = bed.radius;
  json["contacts"] = bed.contacts;
  json["candidates"] = bed.candidates;
  if (!bed.kernel.empty()) {
    json["warp"] = bed.warp;
    json["efficiency"] = bed.efficiency;
  }
  return json;
}

Bed bed_from(const JsonReader& place) {
  Bed bed;
  bed.particles = place.at("particles").whole_number();
  bed.unit = place.at("unit").number();
  bed.slab = optional_string(place, "slab").value_or("");
  bed.kernel = optional_string(place, "kernel").value_or("");
  const std::vector<JsonReader> corners = place.at("box").elements();
  if (corners.size() != 2) place.at("box").fail("no box", "two corners");
  for (std::size_t corner = 0; corner < 2; ++corner) {
    const std::vector<std::int64_t> at = lengths_from(corners[corner]);
    if (at.size() != 3) corners[corner].fail("no corner", "three lengths");
    for (std::size_t axis = 0; axis < 3; ++axis) bed.box[corner][axis] = at[axis];
  }
  bed.x = lengths_from(place.at("x"));
  bed.y = lengths_from(place.at("y"));
  bed.z = lengths_from(place.at("z"));
  bed.radius = lengths_from(place.at("radius"));
  bed.contacts = whole_numbers(place.at("contacts"));
  bed.candidates = whole_numbers(place.at("candidates"));
  if (!bed.kernel.empty()) {
    bed.warp = whole_numbers(place.at("warp"));
    for (const JsonReader& element : place.at("efficiency").elements())
      bed.efficiency.push_back(element.number());
  }
  const std::size_t n = bed.x.size(), of_warps = bed.kernel.empty() ? 0 : n;
  if (bed.y.size() != n || bed.z.size() != n || (bed.radius.size() != n && bed.radius.size() != 1) ||
      bed.contacts.size() != n || bed.candidates.size() != n || bed.warp.size() != of_warps ||
      bed.efficiency.size() != of_warps)
    place.fail("lists of different lengths", fmt::format("{} in each, as in 'x'", n));
  return bed;
}

}  // namespace warpgrain::reports
