#include <array>
#include <optional>
#include <utility>

#include "meshing/detail/faces.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;

constexpr std::array<std::string_view, 4> kRefused{"Hexahedra", "Prisms", "Pyramids",
                                                   "TetrahedraP2"};

bool is_word(std::string_view text) {
  return !text.empty() &&
         ((text[0] >= 'A' && text[0] <= 'Z') || (text[0] >= 'a' && text[0] <= 'z'));
}

struct Sections {
  std::vector<Point> points;
  SourceLines lines;
  detail::Cells cells;
  bool has_references = false;  ///< that differ among the points, or among the cells
  struct References {
    std::optional<double> first = {};
    bool differ(double each) {
      if (!first) first = each;
      return each != *first;
    }
  } of_points, of_cells;
};

template <std::size_t Corners>
void read_cells(Scanner& in, Sections& found, std::string_view what) {
  const std::uint32_t count = in.count(what, 2 * (Corners + 1));
  for (std::uint32_t i = 0; i < count; ++i) {
    std::array<std::uint32_t, Corners> cell;
    for (std::uint32_t& corner : cell) {
      corner = in.natural("the number of a point");
      if (corner == 0) in.fail("point 0 does not exist; Medit numbers points from 1");
      --corner;  // the points may come later in the file: compared with their number at the end
    }
    const std::uint32_t line = in.line();
    if constexpr (Corners == 4) {
      what == "the number of tetrahedra" ? found.cells.add_tetrahedron(cell, line)
                                         : found.cells.add_face(cell, line);
    } else {
      found.cells.add_face(cell, line);
    }
    found.has_references |= found.of_cells.differ(in.number("a reference number"));
  }
}

void read_points(Scanner& in, Sections& found) {
  const std::uint32_t count = in.count("the number of points", 8);
  found.points.reserve(count);
  for (std::uint32_t i = 0; i < count; ++i) {
    found.points.push_back(in.point());
    found.lines.points.push_back(in.line());
    found.has_references |= found.of_points.differ(in.number("a reference number"));
  }
}

void read_section(Scanner& in, std::string_view name, Sections& found) {
  if (name == "Dimension") {
    if (in.natural("the dimension") != 3) in.fail("only meshes in three dimensions are read");
  } else if (name == "Vertices") {
    if (!found.points.empty()) in.fail("a second section \"Vertices\"");
    read_points(in, found);
  } else if (name == "Triangles") {
    read_cells<3>(in, found, "the number of triangles");
  } else if (name == "Tetrahedra") {
    read_cells<4>(in, found, "the number of tetrahedra");
  } else if (name == "Quadrilaterals") {
    read_cells<4>(in, found, "the number of quadrilaterals");
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
  std::vector<std::string> notes;
  if (found.has_references) notes.push_back("reference numbers, which differ, not read");
  return found.cells.finish(std::move(found.points), std::move(found.lines), std::move(notes),
                            "Medit mesh", 1);
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
  const std::vector<Triangle> boundary = boundary_triangles(mesh);
  out += "Triangles\n" + std::to_string(boundary.size()) + "\n";
  for (const Triangle& t : boundary) {
    for (const std::uint32_t corner : t) out += std::to_string(corner + 1) + " ";
    out += "0\n";
  }
  return out + "End\n";
}

}  // namespace tripus::meshing

namespace tripus::meshing::registered_mesh_formats {
namespace {

bool matches(std::string_view content, std::string_view) {
  return detail::first_word(content) == "MeshVersionFormatted";
}

}  // namespace

std::span<const MeshFormat> medit() {
  static constexpr MeshFormat kRows[] = {{"Medit mesh", matches, read_content<read_medit>, 5}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
