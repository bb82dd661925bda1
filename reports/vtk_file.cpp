#include "reports/vtk_file.hpp"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file_io.hpp"
#include "core/neighbour_list.hpp"
#include "core/wall.hpp"

namespace warpgrain::reports {
namespace {

constexpr std::string_view vtk_verts = "Verts", vtk_lines = "Lines";

static_assert(std::endian::native == std::endian::little, "the raw blocks are written in memory order");

// The appended data section: blocks of a 64-bit byte count and the bytes, found by their offset.
class AppendedBlocks {
 public:
  template <class T>
  std::size_t add(const std::vector<T>& values) {
    const std::size_t offset = bytes_.size();
    const std::uint64_t n = values.size() * sizeof(T);
    append(&n, sizeof n);
    append(values.data(), n);
    return offset;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  void append(const void* data, std::size_t n) { bytes_.append(static_cast<const char*>(data), n); }
  std::string bytes_;
};

std::vector<float> packed(const std::vector<Vector3d>& vectors) {
  std::vector<float> out;
  out.reserve(3 * vectors.size());
  for (const Vector3d& v : vectors)
    for (int axis = 0; axis < 3; ++axis) out.push_back(static_cast<float>(v[axis]));
  return out;
}

std::string data_array(std::string_view type, std::string_view name, int components, std::size_t offset) {
  return fmt::format(
      "<DataArray type=\"{}\" Name=\"{}\" NumberOfComponents=\"{}\" format=\"appended\" offset=\"{}\"/>\n",
      type, name, components, offset);
}

// A point or line each: [0, n), in cells of as many points.
struct PolyCells {
  std::vector<std::int64_t> connectivity, offsets;
  PolyCells(std::size_t cells, std::size_t points_of_a_cell) {
    for (std::size_t point = 0; point < cells * points_of_a_cell; ++point)
      connectivity.push_back(static_cast<std::int64_t>(point));
    for (std::size_t cell = 1; cell <= cells; ++cell)
      offsets.push_back(static_cast<std::int64_t>(cell * points_of_a_cell));
  }
};

// A file of one piece, whose cells are Verts or Lines. `arrays` are of its points and cells, and the blocks
// theirs; points and cells come behind.
void write_poly_data(const std::filesystem::path& path, const std::vector<Vector3d>& points,
                     std::string_view kind, const PolyCells& cells, const std::string& arrays,
                     AppendedBlocks blocks) {
  const std::size_t n_cells = cells.offsets.size();
  std::string xml = "<?xml version=\"1.0\"?>\n";
  xml +=
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  xml += fmt::format(
      "<Piece NumberOfPoints=\"{}\" NumberOfVerts=\"{}\" NumberOfLines=\"{}\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      points.size(), kind == vtk_verts ? n_cells : 0, kind == vtk_lines ? n_cells : 0);
  xml += "<Points>\n" + data_array("Float32", "position", 3, blocks.add(packed(points))) + "</Points>\n";
  xml += fmt::format("<{0}>\n{1}{2}</{0}>\n", kind,
                     data_array("Int64", "connectivity", 1, blocks.add(cells.connectivity)),
                     data_array("Int64", "offsets", 1, blocks.add(cells.offsets)));
  xml += arrays + "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  xml += blocks.bytes();
  xml += "\n</AppendedData>\n</VTKFile>\n";
  write_file_atomically(path, xml);
}

Vector3d tangential_displacement(const ContactHistory& history, std::uint32_t particle,
                                 std::uint32_t partner) {
  const auto record = std::ranges::lower_bound(
      history, std::pair(particle, partner), {},
      [](const ContactRecord& each) { return std::pair(each.particle_id, each.partner_id); });
  const bool is_there =
      record != history.end() && record->particle_id == particle && record->partner_id == partner;
  return is_there ? record->tangential_displacement : Vector3d(Vector3d::Zero());
}

}  // namespace

void write_vtk_particles(const std::filesystem::path& path, const ParticleState& state) {
  AppendedBlocks blocks;
  const std::string arrays =
      "<PointData>\n" + data_array("UInt32", "id", 1, blocks.add(state.id)) +
      data_array("Float32", "radius", 1,
                 blocks.add(std::vector<float>(state.radius.begin(), state.radius.end()))) +
      data_array("Float32", "velocity", 3, blocks.add(packed(state.velocity))) +
      data_array("Float32", "angular_velocity", 3, blocks.add(packed(state.angular_velocity))) +
      "</PointData>\n";
  write_poly_data(path, state.position, vtk_verts, PolyCells(state.size(), 1), arrays, std::move(blocks));
}

void write_vtk_contacts(const std::filesystem::path& path, const Scene& scene, const ParticleState& state) {
  NeighbourList<double> touching(scene.domain, scene.walls, state.radius, 0, split_ranges(state.size(), 1));
  touching.build(state.position);
  const PartnerRows& rows = touching.rows(0);
  std::vector<Vector3d> ends, displacements;
  std::vector<std::uint32_t> particles, partners;
  std::vector<float> overlaps;
  for (std::size_t i = 0; i < state.size(); ++i)
    for (std::uint32_t k = rows.row_start[i]; k < rows.row_start[i + 1]; ++k) {
      const std::uint32_t j = rows.partner[k];
      const bool is_wall = (j & wall_partner_bit) != 0;
      const Vector3d& centre = state.position[i];
      ends.push_back(centre);
      if (is_wall) {
        const WallProximity wall = wall_proximity(scene.walls[j & ~wall_partner_bit], centre);
        ends.emplace_back(centre + wall.distance * wall.contact_normal);
        overlaps.push_back(static_cast<float>(state.radius[i] - wall.distance));
      } else {
        ends.push_back(state.position[j]);
        overlaps.push_back(
            static_cast<float>(state.radius[i] + state.radius[j] - (state.position[j] - centre).norm()));
      }
      particles.push_back(state.id[i]);
      partners.push_back(is_wall ? j : state.id[j]);
      displacements.push_back(
          tangential_displacement(state.contact_history, particles.back(), partners.back()));
    }
  AppendedBlocks blocks;
  const std::string arrays =
      "<CellData>\n" + data_array("UInt32", "particle", 1, blocks.add(particles)) +
      data_array("UInt32", "partner", 1, blocks.add(partners)) +
      data_array("Float32", "overlap", 1, blocks.add(overlaps)) +
      data_array("Float32", "tangential_displacement", 3, blocks.add(packed(displacements))) +
      "</CellData>\n";
  write_poly_data(path, ends, vtk_lines, PolyCells(overlaps.size(), 2), arrays, std::move(blocks));
}

}  // namespace warpgrain::reports
