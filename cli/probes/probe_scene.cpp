#include "cli/probes/probe_scene.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <fmt/ranges.h>

namespace warpgrain::cli {
namespace {

std::string vector_text(const Vector3d& v) { return fmt::format("[{}, {}, {}]", v.x(), v.y(), v.z()); }

}  // namespace

std::string ProbeScene::json() const {
  std::vector<std::string> material_rows, contact_rows, body_rows, plane_rows;
  for (std::size_t i = 0; i < materials.size(); ++i) {
    material_rows.push_back(
        fmt::format(R"({{"name": "m{}", "density": {}, "youngs_modulus": {}, "poisson_ratio": 0.3}})", i,
                    materials[i].density, materials[i].youngs_modulus));
    for (std::size_t j = 0; j <= i; ++j)
      contact_rows.push_back(
          fmt::format(R"({{"between": ["m{}", "m{}"], "restitution": {}, "friction": {}}})", j, i,
                      restitution, friction));
  }
  double margin = 0;
  for (const ProbeBody& body : bodies) margin = std::max(margin, room * body.radius);
  Vector3d lower = bodies.front().position, upper = lower;
  for (const ProbeBody& body : bodies) {
    lower = lower.cwiseMin(body.position);
    upper = upper.cwiseMax(body.position);
    body_rows.push_back(fmt::format(R"({{"material": "m{}", "radius": {}, "position": {}, "velocity": {}}})",
                                    body.material, body.radius, vector_text(body.position),
                                    vector_text(body.velocity)));
  }
  for (const ProbePlane& plane : planes)
    plane_rows.push_back(fmt::format(R"({{"material": "m0", "plane": {{"point": {}, "normal": {}}}}})",
                                     vector_text(plane.point), vector_text(plane.normal)));
  return fmt::format(R"({{ "format": "warpgrain.scene/1", "name": "probe", "gravity": {},
  "model": {{"slip_history": "{}"}},
  "materials": [{}],
  "contacts": [{}],
  "particles": [{}],
  "walls": [{}],
  "domain": {{"lower": {}, "upper": {}}},
  "time": {{"step": "auto", "end": {{"steps": 1000}}}} }})",
                     vector_text(gravity), slip_history, fmt::join(material_rows, ", "),
                     fmt::join(contact_rows, ", "), fmt::join(body_rows, ",\n    "),
                     fmt::join(plane_rows, ", "), vector_text((lower.array() - margin).matrix()),
                     vector_text((upper.array() + margin).matrix()));
}

Scene ProbeScene::scene() const { return parse_scene(json(), "probe"); }

}  // namespace warpgrain::cli
