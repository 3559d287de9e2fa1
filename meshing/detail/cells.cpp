#include "meshing/detail/cells.hpp"

#include <string>
#include <utility>

#include "base/error.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::meshing::detail {
namespace {

void require_corners_exist(std::span<const std::uint32_t> corners, std::size_t points,
                           std::uint32_t line, std::string_view format, std::uint32_t first) {
  for (const std::uint32_t corner : corners)
    if (corner >= points)
      throw InvalidInput(std::string(format) +
                         (line > 0 ? ", line " + std::to_string(line) : std::string()) +
                         ": point " + std::to_string(std::uint64_t{corner} + first) +
                         " does not exist; the file has " + std::to_string(points) +
                         " points, numbered from " + std::to_string(first));
}

}  // namespace

MeshFile Cells::finish(std::vector<Point> points, SourceLines lines, std::vector<std::string> notes,
                       std::string_view format, std::uint32_t first) const {
  for (std::size_t i = 0; i < faces_.count(); ++i)
    require_corners_exist(faces_.corners(i), points.size(), faces_.line(i), format, first);
  for (std::size_t i = 0; i < tetrahedra_.size(); ++i)
    require_corners_exist(tetrahedra_[i], points.size(), tetrahedron_lines_[i], format, first);
  if (curved_ > 0)
    notes.push_back(counted(curved_, "curved cell", "curved cells") + " taken by the corners");
  if (left_out_ > 0)
    notes.push_back(counted(left_out_, "point or line cell", "point or line cells") + " left out");
  if (tetrahedra_.empty()) {
    SurfaceFile file{{std::move(points), {}}, std::move(lines), std::move(notes)};
    faces_.finish(file);
    return file;
  }
  TetrahedralFile file{{std::move(points), tetrahedra_}, std::move(lines), std::move(notes)};
  // Most files repeat the boundary, of which nothing is lost.
  if (faces_.count() > 0 && faces_.count() != boundary_triangles(file.mesh).size())
    file.notes.push_back(counted(faces_.count(), "face", "faces") +
                         " beside the tetrahedra left out: their boundary is taken");
  for (const std::uint32_t line : tetrahedron_lines_)
    if (line > 0) file.lines.cells.push_back(line);
  return file;
}

}  // namespace tripus::meshing::detail
