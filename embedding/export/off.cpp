#include <iterator>
#include <ostream>

#include <fmt/format.h>

#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {

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

}  // namespace tripus::embedding
