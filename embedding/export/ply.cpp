#include <cstdint>
#include <ostream>

#include <fmt/format.h>

#include "embedding/colour.hpp"
#include "embedding/detail/bytes.hpp"
#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {

std::size_t write_ply(std::ostream& out, const Tessellation& tessellation) {
  out << fmt::format(
      "ply\nformat binary_little_endian 1.0\n"
      "comment cells of a universal cover, by Tripus; each cell is a closed surface\n"
      "comment side: 0 to 3 the face, 4 to 7 the truncation of vertex 0 to 3\n"
      "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {}\nproperty list uchar int vertex_indices\nproperty uchar red\n"
      "property uchar green\nproperty uchar blue\nproperty int cell\nproperty int tetrahedron\n"
      "property uchar side\nend_header\n",
      tessellation.point_count(), tessellation.triangle_count());
  detail::Bytes bytes(std::endian::little);
  const std::size_t cell_count = tessellation.cells().size();
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    for (const Vector3& point : tessellation.points(c))
      for (const double coordinate : point) bytes.append(coordinate);
    bytes.write_to(out);
  }
  std::uint32_t first = 0;
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    const std::uint32_t tetrahedron = tessellation.cells()[c].tetrahedron;
    const Colour colour = tetrahedron_colour(tetrahedron);
    const auto triangles = tessellation.triangles(c);
    const auto& sides = tessellation.sides(c);
    for (std::size_t n = 0; n < triangles.size(); ++n) {
      bytes.append(std::uint8_t{3});
      for (const std::uint32_t point : triangles[n]) bytes.append(first + point);
      for (const std::uint8_t channel : colour) bytes.append(channel);
      bytes.append(static_cast<std::uint32_t>(c));
      bytes.append(tetrahedron);
      bytes.append(sides[n]);
    }
    bytes.write_to(out);
    first += static_cast<std::uint32_t>(point_count(tessellation.subdivisions(c)));
  }
  return cell_count;
}

}  // namespace tripus::embedding
