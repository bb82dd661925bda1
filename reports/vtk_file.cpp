#include "reports/vtk_file.hpp"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <fmt/format.h>
#include <string>
#include <string_view>
#include <vector>

#include "core/file_io.hpp"

namespace warpgrain::reports {
namespace {

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
  std::string_view bytes() const { return bytes_; }

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

}  // namespace

void write_vtk_particles(const std::filesystem::path& path, const ParticleState& state) {
  const std::size_t n = state.size();
  std::vector<std::int64_t> connectivity(n), offsets(n);
  for (std::size_t i = 0; i < n; ++i) {
    connectivity[i] = static_cast<std::int64_t>(i);
    offsets[i] = static_cast<std::int64_t>(i + 1);
  }
  AppendedBlocks blocks;
  std::string xml = "<?xml version=\"1.0\"?>\n";
  xml +=
      "<VTKFile type=\"PolyData\" version=\"1.0\" byte_order=\"LittleEndian\" "
      "header_type=\"UInt64\">\n<PolyData>\n";
  xml += fmt::format(
      "<Piece NumberOfPoints=\"{0}\" NumberOfVerts=\"{0}\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
      "NumberOfPolys=\"0\">\n",
      n);
  xml +=
      "<Points>\n" + data_array("Float32", "position", 3, blocks.add(packed(state.position))) + "</Points>\n";
  xml += "<Verts>\n" + data_array("Int64", "connectivity", 1, blocks.add(connectivity)) +
         data_array("Int64", "offsets", 1, blocks.add(offsets)) + "</Verts>\n";
  xml += "<PointData>\n" + data_array("UInt32", "id", 1, blocks.add(state.id)) +
         data_array("Float32", "radius", 1,
                    blocks.add(std::vector<float>(state.radius.begin(), state.radius.end()))) +
         data_array("Float32", "velocity", 3, blocks.add(packed(state.velocity))) +
         data_array("Float32", "angular_velocity", 3, blocks.add(packed(state.angular_velocity))) +
         "</PointData>\n";
  xml += "</Piece>\n</PolyData>\n<AppendedData encoding=\"raw\">\n_";
  xml += blocks.bytes();
  xml += "\n</AppendedData>\n</VTKFile>\n";
  write_file_atomically(path, xml);
}

}  // namespace warpgrain::reports
