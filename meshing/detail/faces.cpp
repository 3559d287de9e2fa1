#include "meshing/detail/faces.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include "base/error.hpp"
#include "meshing/detail/polygon.hpp"
#include "meshing/validate_tetrahedra.hpp"

namespace tripus::meshing::detail {

void Faces::add(std::span<const std::uint32_t> corners, std::uint32_t line) {
  const std::size_t begin = corners_.size();
  for (const std::uint32_t corner : corners)
    if (corners_.size() == begin || corners_.back() != corner || corners.size() == 3)
      corners_.push_back(corner);
  if (corners.size() > 3)
    while (corners_.size() > begin + 1 && corners_.back() == corners_[begin]) corners_.pop_back();
  if (corners_.size() - begin > kMostCorners)
    throw InvalidInput("face " + std::to_string(count()) + " has " +
                       std::to_string(corners.size()) + " corners; at most " +
                       std::to_string(kMostCorners) + " are read");
  start_.push_back(corners_.size());
  lines_.push_back(line);
}

void Faces::add_strip(std::span<const std::uint32_t> corners, std::uint32_t line) {
  ++strips_;
  for (std::size_t i = 2; i < corners.size(); ++i) {
    Triangle t{corners[i - 2], corners[i - 1], corners[i]};
    if (i % 2 == 1) std::swap(t[0], t[1]);
    // Strips turn corners by repeating a point.
    if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0]) add(t, line);
  }
}

void Faces::finish(SurfaceFile& file) const {
  std::size_t cut = 0, bent = 0, small = 0;
  auto& triangles = file.mesh.triangles;
  std::vector<std::uint32_t> numbers;
  for (std::size_t f = 0; f < count(); ++f) {
    const auto face = corners(f);
    if (face.size() < 3) {
      ++small;
      continue;
    }
    if (face.size() > 3) {
      ++cut;
      if (!is_planar(file.mesh.points, face)) ++bent;
    }
    cut_polygon(file.mesh.points, face, triangles);
    while (numbers.size() < triangles.size()) {
      numbers.push_back(static_cast<std::uint32_t>(f));
      if (lines_[f] > 0) file.lines.cells.push_back(lines_[f]);
    }
  }
  if (cut + small + strips_ > 0) file.lines.cell_numbers = std::move(numbers);
  if (strips_ > 0)
    file.notes.push_back(counted(strips_, "strip", "strips") + " taken apart into triangles");
  if (cut > 0)
    file.notes.push_back(
        counted(cut, "face", "faces") + " of more than three corners cut into triangles" +
        (bent > 0 ? ", " + std::to_string(bent) + " of them not planar" : std::string()));
  if (small > 0)
    file.notes.push_back(counted(small, "face", "faces") + " of fewer than three corners left out");
}

std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return std::to_string(count) + " " + std::string(count == 1 ? one : many);
}

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
