#include <iterator>
#include <ostream>

#include <fmt/format.h>

#include "embedding/export/mesh_formats.hpp"

namespace tripus::embedding {

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

}  // namespace tripus::embedding
