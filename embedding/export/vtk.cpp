#include <cstdint>
#include <ostream>

#include <fmt/format.h>

#include "embedding/colour.hpp"
#include "embedding/detail/bytes.hpp"
#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {
namespace {

// The legacy format is big-endian on every machine.
constexpr std::endian kOrder = std::endian::big;

/// One integer for each triangle: value(cell, triangle within the cell).
template <class Value>
void write_integers(std::ostream& out, const Tessellation& tessellation, const char* name,
                    Value value) {
  out << fmt::format("SCALARS {} int 1\nLOOKUP_TABLE default\n", name);
  detail::ByteBuffer bytes(kOrder);
  for (std::size_t c = 0; c < tessellation.cells().size() && out; ++c) {
    const std::size_t count = triangle_count(tessellation.subdivisions(c));
    for (std::size_t n = 0; n < count; ++n) bytes.append(static_cast<std::int32_t>(value(c, n)));
    bytes.write_to(out);
  }
  out << '\n';
}

template <class Number>
void write_surface(std::ostream& out, const Tessellation& tessellation) {
  const std::size_t cell_count = tessellation.cells().size();
  detail::ByteBuffer bytes(kOrder);
  out << fmt::format("POINTS {} {}\n", tessellation.point_count(),
                     sizeof(Number) == sizeof(float) ? "float" : "double");
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    for (const Vector3& point : tessellation.points(c))
      for (const double coordinate : point) bytes.append(static_cast<Number>(coordinate));
    bytes.write_to(out);
  }
  out << fmt::format("\nPOLYGONS {} {}\n", tessellation.triangle_count(),
                     4 * tessellation.triangle_count());
  std::uint32_t first = 0;
  for (std::size_t c = 0; c < cell_count && out; ++c) {
    for (const auto& triangle : tessellation.triangles(c)) {
      bytes.append(std::int32_t{3});
      for (const std::uint32_t point : triangle) bytes.append(first + point);
    }
    bytes.write_to(out);
    first += static_cast<std::uint32_t>(point_count(tessellation.subdivisions(c)));
  }
}

template <class Number>
std::size_t write(std::ostream& out, const Tessellation& tessellation) {
  out << "# vtk DataFile Version 3.0\ncells of a universal cover, by Tripus\nBINARY\n"
         "DATASET POLYDATA\n";
  write_surface<Number>(out, tessellation);
  out << fmt::format("\nCELL_DATA {}\n", tessellation.triangle_count());
  const auto cells = tessellation.cells();
  write_integers(out, tessellation, "cell", [](std::size_t c, std::size_t) { return c; });
  write_integers(out, tessellation, "tetrahedron",
                 [&](std::size_t c, std::size_t) { return cells[c].tetrahedron; });
  write_integers(out, tessellation, "depth",
                 [&](std::size_t c, std::size_t) { return cells[c].depth; });
  write_integers(out, tessellation, "side",
                 [&](std::size_t c, std::size_t n) { return tessellation.sides(c)[n]; });
  out << "COLOR_SCALARS colour 3\n";
  detail::ByteBuffer bytes(kOrder);
  for (std::size_t c = 0; c < cells.size() && out; ++c) {
    const Colour colour = tetrahedron_colour(cells[c].tetrahedron);
    for (std::size_t n = 0; n < triangle_count(tessellation.subdivisions(c)); ++n)
      for (const std::uint8_t channel : colour) bytes.append(channel);
    bytes.write_to(out);
  }
  out << '\n';
  return cells.size();
}

}  // namespace

std::size_t write_vtk(std::ostream& out, const Tessellation& tessellation) {
  return write<double>(out, tessellation);
}

std::size_t write_float_vtk(std::ostream& out, const Tessellation& tessellation) {
  return write<float>(out, tessellation);
}

}  // namespace tripus::embedding
