#include <cstdint>
#include <ostream>
#include <string>

#include <Eigen/Geometry>

#include "embedding/detail/bytes.hpp"
#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {

std::size_t write_stl(std::ostream& out, const Tessellation& tessellation) {
  constexpr std::size_t kHeader = 80;
  std::string header = "cells of a universal cover, by Tripus";
  header.resize(kHeader, ' ');
  out << header;
  detail::ByteBuffer bytes(std::endian::little);
  bytes.append(static_cast<std::uint32_t>(tessellation.triangle_count()));
  const std::size_t cell_count = tessellation.cells().size();
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    const std::vector<Vector3> points = tessellation.points(c);
    for (const auto& [p, q, r] : tessellation.triangles(c)) {
      const Vector3 normal =
          (points[q] - points[p]).cross(points[r] - points[p]).stableNormalized();
      for (const Vector3& vector : {normal, points[p], points[q], points[r]})
        for (const double coordinate : vector) bytes.append(static_cast<float>(coordinate));
      bytes.append(std::uint16_t{0});
    }
    bytes.write_to(out);
  }
  return cell_count;
}

}  // namespace tripus::embedding
