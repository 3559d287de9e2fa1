#include "meshing/formats/vtk.hpp"

#include <array>
#include <optional>
#include <utility>
#include <vector>

#include "meshing/detail/bytes.hpp"
#include "meshing/detail/scanner.hpp"
#include "meshing/detail/text.hpp"

namespace tripus::meshing {
namespace {

using detail::Bytes;
using detail::Scanner;

// Numbers of VTK's cell types; those below kTriangle are points and lines.
constexpr std::uint64_t kTriangle = 5, kTetrahedron = 10;

/// Numbers of the file: words, or big-endian binary blocks between the lines of text.
class Reader {
 public:
  Reader(Scanner text, bool binary) : text_(text), binary_(binary) {}

  Scanner& text() { return text_; }

  std::vector<double> floats(std::uint64_t count, std::string_view type) {
    if (type == "float") return take<float, double>(count);
    if (type == "double") return take<double, double>(count);
    text_.fail("coordinates of type " + quoted(std::string(type.substr(0, 32))) +
               "; expected float or double");
  }
  std::vector<std::uint64_t> naturals(std::uint64_t count, std::string_view type) {
    if (type == "int" || type == "vtktypeint32") return take<std::int32_t, std::uint64_t>(count);
    if (type == "vtktypeint64" || type == "vtkIdType" || type == "long")
      return take<std::int64_t, std::uint64_t>(count);
    text_.fail("indices of type " + quoted(std::string(type.substr(0, 32))));
  }
  /// The line of each number taken last; empty for binary files.
  const std::vector<std::uint32_t>& lines() const { return lines_; }

 private:
  template <class Stored, class Number>
  std::vector<Number> take(std::uint64_t count) {
    const std::size_t least = binary_ ? sizeof(Stored) : 2;
    if (count > text_.room(least))
      text_.fail(std::to_string(count) +
                 " numbers announced, more than the file is long enough for");
    std::vector<Number> numbers;
    numbers.reserve(count);
    lines_.clear();
    if (!binary_) {
      for (std::uint64_t i = 0; i < count; ++i) {
        if constexpr (std::is_floating_point_v<Stored>) {
          numbers.push_back(text_.number("a coordinate"));
        } else {
          numbers.push_back(text_.natural("an index"));
        }
        lines_.push_back(text_.line());
      }
      return numbers;
    }
    text_.next_line();
    Bytes bytes("VTK", text_.rest(), true);
    for (std::uint64_t i = 0; i < count; ++i) {
      const Stored value = bytes.take<Stored>("a number");
      if constexpr (std::is_integral_v<Stored>)
        if (value < 0) bytes.fail("a negative index");
      numbers.push_back(static_cast<Number>(value));
    }
    text_.skip_bytes(count * sizeof(Stored));
    return numbers;
  }

  Scanner text_;
  bool binary_;
  std::vector<std::uint32_t> lines_;
};

struct Cells {
  std::vector<std::uint64_t> corners;  ///< of all cells
  std::vector<std::uint64_t> start;    ///< [cells + 1] into corners
  std::vector<std::uint32_t> lines;    ///< [cells], or nothing
  std::vector<std::uint64_t> types;
};

/// Up to version 4: for each cell its number of corners and the corners, `size` numbers in all.
Cells read_cells(Reader& in, std::uint32_t count, std::uint32_t size) {
  const auto numbers = in.naturals(size, "int");
  Cells cells;
  cells.start.push_back(0);
  std::size_t at = 0;
  for (std::uint32_t i = 0; i < count; ++i) {
    if (at >= numbers.size() || numbers[at] > numbers.size() - at - 1)
      in.text().fail("cell " + std::to_string(i) + " goes beyond the " + std::to_string(size) +
                     " numbers announced");
    if (!in.lines().empty()) cells.lines.push_back(in.lines()[at]);
    const std::size_t end = at + 1 + numbers[at];
    for (++at; at < end; ++at) cells.corners.push_back(numbers[at]);
    cells.start.push_back(cells.corners.size());
  }
  return cells;
}

/// From version 5: offsets, then corners.
Cells read_cells_by_offsets(Reader& in, std::uint32_t offsets, std::uint32_t corners) {
  Cells cells;
  const std::string_view offset_type = in.text().word();
  cells.start = in.naturals(offsets, offset_type);
  if (in.text().word() != "CONNECTIVITY") in.text().fail("CONNECTIVITY was expected after OFFSETS");
  const std::string_view corner_type = in.text().word();
  cells.corners = in.naturals(corners, corner_type);
  for (std::size_t i = 0; i < cells.start.size(); ++i)
    if (cells.start[i] > cells.corners.size() || (i > 0 && cells.start[i] < cells.start[i - 1]))
      in.text().fail("offset " + std::to_string(cells.start[i]) + " of cell " + std::to_string(i));
  if (cells.start.empty()) cells.start.push_back(0);
  return cells;
}

Cells read_cell_block(Reader& in) {
  const std::uint32_t first = in.text().natural("a count");
  const std::uint32_t second = in.text().natural("a size");
  Scanner ahead = in.text();
  if (ahead.word() != "OFFSETS") return read_cells(in, first, second);
  in.text() = ahead;
  return read_cells_by_offsets(in, first, second);
}

template <std::size_t Corners>
void collect(Reader& in, const Cells& cells, std::uint64_t type, std::size_t points,
             std::vector<std::array<std::uint32_t, Corners>>& out, SourceLines& lines) {
  for (std::size_t i = 0; i + 1 < cells.start.size(); ++i) {
    if (cells.types[i] != type) continue;
    const std::size_t size = cells.start[i + 1] - cells.start[i];
    const std::string place = "cell " + std::to_string(i);
    if (size != Corners)
      in.text().fail(place + " has " + std::to_string(size) + " corners; expected " +
                     std::to_string(Corners));
    std::array<std::uint32_t, Corners> cell;
    for (std::size_t k = 0; k < Corners; ++k) {
      const std::uint64_t corner = cells.corners[cells.start[i] + k];
      if (corner >= points) {
        const std::string what = place + ": point " + std::to_string(corner) +
                                 " does not exist; the file has " + std::to_string(points) +
                                 " points, numbered from 0";
        if (!cells.lines.empty()) in.text().fail_at(cells.lines[i], what);
        throw InvalidInput("VTK: " + what);
      }
      cell[k] = static_cast<std::uint32_t>(corner);
    }
    out.push_back(cell);
    if (!cells.lines.empty()) lines.cells.push_back(cells.lines[i]);
  }
}

bool holds(const Cells& cells, std::uint64_t type) {
  for (const std::uint64_t each : cells.types)
    if (each == type) return true;
  return false;
}

/// What a grid of cells is, once all of it was read.
MeshFile assemble(Reader& in, std::vector<Point> points, SourceLines lines, const Cells& cells) {
  if (cells.types.size() + 1 != cells.start.size())
    in.text().fail(std::to_string(cells.types.size()) + " cell types for " +
                   std::to_string(cells.start.size() - 1) + " cells");
  for (std::size_t i = 0; i < cells.types.size(); ++i) {
    const std::uint64_t type = cells.types[i];
    if (type > kTriangle && type != kTetrahedron)
      in.text().fail("cell " + std::to_string(i) + " is of VTK type " + std::to_string(type) +
                     "; only triangles (5) and tetrahedra (10) are read");
  }
  if (holds(cells, kTetrahedron)) {
    TetrahedralFile file{{std::move(points), {}}, std::move(lines)};
    collect(in, cells, kTetrahedron, file.mesh.points.size(), file.mesh.tetrahedra, file.lines);
    return file;
  }
  SurfaceFile file{{std::move(points), {}}, std::move(lines)};
  collect(in, cells, kTriangle, file.mesh.points.size(), file.mesh.triangles, file.lines);
  return file;
}

void read_points(Reader& in, std::vector<Point>& points, SourceLines& lines) {
  const std::uint32_t count = in.text().natural("the number of points");
  const std::string_view type = in.text().word();
  const auto numbers = in.floats(3 * std::uint64_t{count}, type);
  points.resize(count);
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) points[i][k] = numbers[3 * i + k];
  for (std::size_t i = 0; i < in.lines().size(); i += 3) lines.points.push_back(in.lines()[i]);
}

/// Blocks that nobody needs end with an empty line.
void skip_metadata(Scanner& in) {
  while (in.next_line() && !in.word_of_line().empty()) {
    while (!in.word_of_line().empty()) {
    }
  }
}

MeshFile read_body(Reader& in) {
  std::vector<Point> points;
  SourceLines lines;
  std::optional<Cells> cells;
  for (std::string_view key = in.text().word(); !key.empty(); key = in.text().word()) {
    if (key == "POINTS") {
      read_points(in, points, lines);
    } else if (key == "CELLS") {
      cells = read_cell_block(in);
    } else if (key == "CELL_TYPES" && cells) {
      cells->types = in.naturals(in.text().natural("a count"), "int");
    } else if (key == "POLYGONS") {
      cells = read_cell_block(in);
      cells->types.assign(cells->start.size() - 1, kTriangle);
      for (std::size_t i = 0; i + 1 < cells->start.size(); ++i)
        if (cells->start[i + 1] - cells->start[i] != 3)
          in.text().fail("polygon " + std::to_string(i) +
                         detail::not_a_triangle(cells->start[i + 1] - cells->start[i]));
    } else if (key == "VERTICES" || key == "LINES") {
      read_cell_block(in);
    } else if (key == "METADATA") {
      skip_metadata(in.text());
    } else if (key == "POINT_DATA" || key == "CELL_DATA" || key == "FIELD") {
      break;
    } else {
      in.text().fail(quoted(std::string(key.substr(0, 32))) +
                     " where POINTS, CELLS, CELL_TYPES or POLYGONS was expected");
    }
  }
  if (!cells) in.text().fail("the file has no cells");
  return assemble(in, std::move(points), std::move(lines), *cells);
}

}  // namespace

MeshFile read_vtk(std::string_view text) {
  Scanner in("VTK", text, '\0');
  if (!text.starts_with("# vtk DataFile"))
    in.fail("the file does not begin with \"# vtk DataFile\"");
  in.next_line();
  in.next_line();  // the title
  const std::string_view coding = in.word();
  if (coding != "ASCII" && coding != "BINARY") in.fail("ASCII or BINARY was expected");
  if (in.word() != "DATASET") in.fail("DATASET was expected");
  const std::string_view kind = in.word();
  if (kind != "UNSTRUCTURED_GRID" && kind != "POLYDATA")
    in.fail("a data set of kind " + quoted(std::string(kind.substr(0, 32))) +
            "; expected UNSTRUCTURED_GRID or POLYDATA");
  Reader reader(in, coding == "BINARY");
  return read_body(reader);
}

std::string write_vtk(const TetrahedralMesh& mesh) {
  const std::string count = std::to_string(mesh.tetrahedra.size());
  std::string out =
      "# vtk DataFile Version 3.0\ntripus\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS " +
      std::to_string(mesh.points.size()) + " double\n";
  for (const Point& p : mesh.points) detail::append_numbers(out, p);
  out += "CELLS " + count + " " + std::to_string(5 * mesh.tetrahedra.size()) + "\n";
  for (const Tetrahedron& t : mesh.tetrahedra) {
    out += "4";
    for (const std::uint32_t corner : t) out += " " + std::to_string(corner);
    out += "\n";
  }
  out += "CELL_TYPES " + count + "\n";
  for (std::size_t i = 0; i < mesh.tetrahedra.size(); ++i) out += "10\n";
  return out;
}

}  // namespace tripus::meshing
