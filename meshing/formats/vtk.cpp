#include "meshing/detail/vtk.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "meshing/detail/text.hpp"
#include "meshing/formats/formats.hpp"

namespace tripus::meshing {
namespace {

using detail::Scanner;
using detail::VtkCells;
using detail::VtkNumbers;

constexpr std::string_view kBegin = "# vtk DataFile";

/// Up to version 4: for each cell its number of corners and the corners, `size` numbers in all.
VtkCells read_cells(VtkNumbers& in, std::uint32_t count, std::uint32_t size) {
  const auto numbers = in.naturals(size, "int");
  VtkCells cells;
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

/// Blocks that nobody needs end with an empty line.
void skip_metadata(Scanner& in) {
  while (in.next_line() && !in.word_of_line().empty()) {
    while (!in.word_of_line().empty()) {
    }
  }
}

/// From version 5: offsets, then corners.
VtkCells read_cells_by_offsets(VtkNumbers& in, std::uint32_t offsets, std::uint32_t corners) {
  VtkCells cells;
  cells.start = in.naturals(offsets, in.text().word());
  std::string key = in.key();
  for (; key == "metadata"; key = in.key()) skip_metadata(in.text());
  if (key != "connectivity") in.text().fail("CONNECTIVITY was expected after OFFSETS");
  cells.corners = in.naturals(corners, in.text().word());
  for (std::size_t i = 0; i < cells.start.size(); ++i)
    if (cells.start[i] > cells.corners.size() || (i > 0 && cells.start[i] < cells.start[i - 1]))
      in.text().fail("offset " + std::to_string(cells.start[i]) + " of cell " + std::to_string(i));
  return cells;
}

VtkCells read_cell_block(VtkNumbers& in) {
  const std::uint32_t first = in.text().natural("a count");
  const std::uint32_t second = in.text().natural("a size");
  VtkNumbers ahead = in;
  std::string key = ahead.key();
  for (; key == "metadata"; key = ahead.key()) skip_metadata(ahead.text());
  if (key != "offsets") return read_cells(in, first, second);
  in = std::move(ahead);
  return read_cells_by_offsets(in, first, second);
}

/// Arrays of any kind, each with its name, components, tuples and type.
void skip_field(VtkNumbers& in) {
  in.text().word();  // the name
  const std::uint32_t arrays = in.text().natural("the number of arrays");
  for (std::uint32_t i = 0; i < arrays; ++i) {
    std::string name = in.key();
    for (; name == "metadata"; name = in.key()) skip_metadata(in.text());
    if (name == "null_array") continue;
    const std::uint64_t components = in.text().natural("the number of components");
    const std::uint64_t tuples = in.text().natural("the number of tuples");
    in.skip(components * tuples, in.text().word());
  }
}

/// What the sections of a file have.
struct Sections {
  std::vector<Point> points;
  SourceLines lines;
  VtkCells grid;
  std::vector<std::uint64_t> types;
  struct Block {
    VtkCells cells;
    std::uint64_t type;
  };
  std::vector<Block> blocks;  ///< of POLYDATA
  bool has_grid = false;
  bool has_data = false;
};

void read_points(VtkNumbers& in, Sections& found) {
  const std::uint32_t count = in.text().natural("the number of points");
  const auto numbers = in.floats(3 * std::uint64_t{count}, in.text().word());
  found.points.resize(count);
  found.lines.points.clear();
  for (std::size_t i = 0; i < count; ++i)
    for (std::size_t k = 0; k < 3; ++k) found.points[i][k] = numbers[3 * i + k];
  for (std::size_t i = 0; i < in.lines().size(); i += 3)
    found.lines.points.push_back(in.lines()[i]);
}

/// Reads a section; false where the data of points and cells begin, which come last.
bool read_section(VtkNumbers& in, const std::string& key, Sections& found) {
  if (key == "points") {
    read_points(in, found);
  } else if (key == "cells") {
    found.grid = read_cell_block(in);
    found.has_grid = true;
  } else if (key == "cell_types") {
    found.types = in.naturals(in.text().natural("a count"), "int");
  } else if (key == "polygons") {
    found.blocks.push_back({read_cell_block(in), detail::kVtkPolygon});
  } else if (key == "triangle_strips") {
    found.blocks.push_back({read_cell_block(in), detail::kVtkStrip});
  } else if (key == "vertices" || key == "lines") {
    found.blocks.push_back({read_cell_block(in), detail::kVtkLine});
  } else if (key == "metadata") {
    skip_metadata(in.text());
  } else if (key == "field") {
    skip_field(in);
    found.has_data = true;
  } else if (key == "point_data" || key == "cell_data") {
    found.has_data = true;
    return false;
  } else {
    in.text().fail(quoted(key.substr(0, 32)) +
                   " where POINTS, CELLS, CELL_TYPES or POLYGONS was expected");
  }
  return true;
}

MeshFile read_body(VtkNumbers& in, bool has_field) {
  Sections found;
  found.has_data = has_field;
  for (std::string key = in.key(); !key.empty(); key = in.key())
    if (!read_section(in, key, found)) break;
  if (!found.has_grid && found.blocks.empty()) in.text().fail("the file has no cells");
  detail::Cells cells;
  const std::size_t points = found.points.size();
  if (found.has_grid) detail::add_vtk_cells(found.grid, found.types, points, "VTK", cells);
  for (const auto& block : found.blocks)
    detail::add_vtk_cells(block.cells, block.type, points, "VTK", cells);
  std::vector<std::string> notes;
  if (found.has_data) notes.push_back("data of the points, the cells and the whole not read");
  return cells.finish(std::move(found.points), std::move(found.lines), std::move(notes), "VTK", 0);
}

}  // namespace

bool starts_vtk(std::string_view content) {
  return detail::lowered(content.substr(0, kBegin.size())) == detail::lowered(kBegin);
}

MeshFile read_vtk(std::string_view text) {
  Scanner in("VTK", text, '\0');
  if (!starts_vtk(text)) in.fail("the file does not begin with \"# vtk DataFile\"");
  in.next_line();
  in.next_line();  // the title
  const std::string coding = detail::lowered(in.word());
  if (coding != "ascii" && coding != "binary") in.fail("ASCII or BINARY was expected");
  VtkNumbers numbers(in, coding == "binary");
  std::string key = numbers.key();
  // Field data of the file stands before the data set or in it.
  bool has_field = false;
  for (; key == "field" || key == "metadata"; key = numbers.key()) {
    has_field = has_field || key == "field";
    key == "field" ? skip_field(numbers) : skip_metadata(numbers.text());
  }
  if (key != "dataset") numbers.text().fail("DATASET was expected");
  const std::string given(numbers.text().word());
  const std::string kind = detail::lowered(given);
  if (kind != "unstructured_grid" && kind != "polydata")
    numbers.text().fail("a data set of kind " + quoted(given.substr(0, 32)) +
                        "; expected UNSTRUCTURED_GRID or POLYDATA: extract its surface first");
  return read_body(numbers, has_field);
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

namespace tripus::meshing::registered_mesh_formats {
std::span<const MeshFormat> vtk() {
  static constexpr MeshFormat kRows[] = {
      {"VTK legacy", matches_content<starts_vtk>, read_content<read_vtk>, 1}};
  return kRows;
}

}  // namespace tripus::meshing::registered_mesh_formats
