#include <cstdint>
#include <ostream>

#include <fmt/format.h>

#include "embedding/colour.hpp"
#include "embedding/detail/bytes.hpp"
#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {

// Everything that is told stands at the points, each of which belongs to one cell: some readers
// refuse binary faces with properties beside their corners, and colours of points are what all
// know.
std::size_t write_ply(std::ostream& out, const Tessellation& tessellation) {
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment cells of a universal cover, by Tripus; each cell is a closed surface\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "property uchar red\nproperty uchar green\nproperty uchar blue\nproperty int cell\n"
      "property int tetrahedron\n"
      "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
      tessellation.point_count(), tessellation.triangle_count());
  detail::ByteBuffer bytes(std::endian::little);
  const std::size_t cell_count = tessellation.cells().size();
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    const std::uint32_t tetrahedron = tessellation.cells()[c].tetrahedron;
    const Colour colour = tetrahedron_colour(tetrahedron);
    for (const Vector3& point : tessellation.points(c)) {
      for (const double coordinate : point) bytes.append(coordinate);
      for (const std::uint8_t channel : colour) bytes.append(channel);
      bytes.append(static_cast<std::uint32_t>(c));
      bytes.append(tetrahedron);
    }
    bytes.write_to(out);
  }
  std::uint32_t first = 0;
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    for (const auto& triangle : tessellation.triangles(c)) {
      bytes.append(std::uint8_t{3});
      for (const std::uint32_t point : triangle) bytes.append(first + point);
    }
    bytes.write_to(out);
    first += static_cast<std::uint32_t>(point_count(tessellation.subdivisions(c)));
  }
  return cell_count;
}

}  // namespace tripus::embedding
