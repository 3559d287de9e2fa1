#include "meshing/formats/medit.hpp"

#include <array>
#include <utility>

#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

constexpr std::array<std::string_view, 6> kRefused{"Hexahedra",      "Prisms",  "Pyramids",
                                                   "Quadrilaterals", "Edges3D", "TetrahedraP2"};

bool is_word(std::string_view text) {
  return !text.empty() &&
         ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z'));
}

struct Sections {
  std::vector<Point> points;
  SourceLines lines;
  std::vector<Triangle> triangles;
  std::vector<Tetrahedron> tetrahedra;
  std::vector<std::uint32_t> triangle_lines, tetrahedron_lines;
};

template <std::size_t Corners>
void read_cells(Scanner& in, std::vector<std::array<std::uint32_t, Corners>>& cells,
                std::vector<std::uint32_t>& lines, std::string_view what) {
  const std::uint32_t count = in.count(what, 2 * (Corners + 1));
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, Corners> cell;
    for (std::uint32_t& corner : cell) {
      corner = in.natural("the number of a point");
      if (corner == 0) in.fail("point 0 does not exist; Medit numbers points from 1");
      --corner;  // the points may come later in the file: compared with their number at the end
    }
    cells.push_back(cell);
    lines.push_back(in.line());
    in.number("a reference number");
  }
}

void read_points(Scanner& in, Sections& found) {
  const std::uint32_t count = in.count("the number of points", 8);
  found.points.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    found.points.push_back(in.point());
    found.lines.points.push_back(in.line());
    in.number("a reference number");
  }
}

template <class Cells>
void check_corners(const Scanner& in, const Cells& cells, const std::vector<std::uint32_t>& lines,
                   std::size_t points) {
  for (std::size_t i = 0; i < cells.size(); ++i)
    for (const std::uint32_t corner : cells[i])
      if (corner >= points)
        in.fail_at(lines[i], "point " + std::to_string(corner + std::uint64_t{1}) +
                                 " does not exist; the file has " + std::to_string(points) +
                                 " points, numbered from 1");
}

void read_section(Scanner& in, std::string_view name, Sections& found) {
  if (name == "Dimension") {
    if (in.natural("the dimension") != 3) in.fail("only meshes in three dimensions are read");
  } else if (name == "Vertices") {
    if (!found.points.empty()) in.fail("a second section \"Vertices\"");
    read_points(in, found);
  } else if (name == "Triangles") {
    read_cells(in, found.triangles, found.triangle_lines, "the number of triangles");
  } else if (name == "Tetrahedra") {
    read_cells(in, found.tetrahedra, found.tetrahedron_lines, "the number of tetrahedra");
  } else {
    for (const std::string_view refused : kRefused)
      if (name == refused && in.natural("a count") != 0)
        in.fail(std::string(name) + " are not supported; only triangles and tetrahedra are read");
    // Any other section: up to the next word that is not a number.
    for (Scanner ahead = in; !is_word(ahead.word()) && !ahead.rest().empty();) in = ahead;
  }
}

}  // namespace

MeshFile read_medit(std::string_view text) {
  Scanner in("Medit mesh", text, '#');
  if (in.word() != "MeshVersionFormatted")
    in.fail("the file does not begin with \"MeshVersionFormatted\"");
  in.natural("the version");
  Sections found;
  for (std::string_view name = in.word(); !name.empty() && name != "End"; name = in.word()) {
    if (!is_word(name))
      in.fail(quoted(std::string(name.substr(0, 32))) +
              " where the name of a section was expected");
    read_section(in, name, found);
  }
  check_corners(in, found.triangles, found.triangle_lines, found.points.size());
  check_corners(in, found.tetrahedra, found.tetrahedron_lines, found.points.size());
  if (found.tetrahedra.empty()) {
    found.lines.cells = std::move(found.triangle_lines);
    return SurfaceFile{{std::move(found.points), std::move(found.triangles)},
                       std::move(found.lines)};
  }
  found.lines.cells = std::move(found.tetrahedron_lines);
  return TetrahedralFile{{std::move(found.points), std::move(found.tetrahedra)},
                         std::move(found.lines)};
}

std::string write_medit(const TetrahedralMesh& mesh) {
  std::string out =
      "MeshVersionFormatted 2\nDimension 3\nVertices\n" + std::to_string(mesh.points.size()) + "\n";
  for (const Point& p : mesh.points) {
    detail::append_numbers(out, p);
    out.insert(out.size() - 1, " 0");
  }
  out += "Tetrahedra\n" + std::to_string(mesh.tetrahedra.size()) + "\n";
  for (const Tetrahedron& t : mesh.tetrahedra) {
    for (const std::uint32_t corner : t) out += std::to_string(corner + 1) + " ";
    out += "0\n";
  }
  return out + "End\n";
}

}  // namespace tripus::meshing
