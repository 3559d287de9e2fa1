#include "embedding/export/mesh_formats.hpp"

#include <array>
#include <cstdint>
#include <iterator>
#include <ostream>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "embedding/colour.hpp"
#include "embedding/detail/bytes.hpp"

namespace tripus::embedding {
std::span<const CellFormat> mesh_formats() {
  static constexpr std::array<CellFormat, 8> formats{{
      {"obj", "Wavefront OBJ: a group for each cell", write_obj},
      {"ply", "binary PLY: colour, cell and tetrahedron of each point", write_ply},
      {"off", "Geomview's OFF", write_off},
      {"stl", "binary STL, in single precision", write_stl},
      {"glb", "glTF 2.0, binary: a mesh and a colour for each tetrahedron", write_glb},
      {"gltf", "the same as text", write_gltf},
      {"float.vtk", "as .vtk, but in single precision", write_float_vtk},
      {"vtk", "binary VTK legacy PolyData with cell data, for ParaView", write_vtk},
  }};
  return formats;
}

std::size_t write_obj(std::ostream& out, const Tessellation& tessellation) {
  out << "# cells of a universal cover, by Tripus; each group is a closed surface\n";
  std::size_t first = 1;  // OBJ counts from 1
  fmt::memory_buffer text;
  std::size_t c = 0;
  for (; c < tessellation.cells().size() && out; ++c) {
    if (c > 0 && tessellation.is_stopped()) break;
    text.clear();
    const auto to = std::back_inserter(text);
    const std::uint32_t tetrahedron = tessellation.cells()[c].tetrahedron;
    fmt::format_to(to, "g cell_{}_tetrahedron_{}\n", c, tetrahedron);
    const std::vector<Vector3> points = tessellation.points(c);
    // No colours: some readers take them for more coordinates.
    for (const Vector3& p : points) fmt::format_to(to, "v {} {} {}\n", p[0], p[1], p[2]);
    for (const auto& [p, q, r] : tessellation.triangles(c))
      fmt::format_to(to, "f {} {} {}\n", first + p, first + q, first + r);
    first += points.size();
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
  }
  return c;
}

std::size_t write_off(std::ostream& out, const Tessellation& tessellation) {
  out << fmt::format("OFF\n{} {} 0\n", tessellation.point_count(), tessellation.triangle_count());
  const std::size_t cell_count = tessellation.cells().size();
  fmt::memory_buffer text;
  const auto write = [&] {
    out.write(text.data(), static_cast<std::streamsize>(text.size()));
    text.clear();
  };
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    for (const Vector3& p : tessellation.points(c))
      fmt::format_to(std::back_inserter(text), "{} {} {}\n", p[0], p[1], p[2]);
    write();
  }
  std::size_t first = 0;
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    // No colours: some readers take them for corners.
    for (const auto& [p, q, r] : tessellation.triangles(c))
      fmt::format_to(std::back_inserter(text), "3 {} {} {}\n", first + p, first + q, first + r);
    write();
    first += point_count(tessellation.subdivisions(c));
  }
  return cell_count;
}

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
