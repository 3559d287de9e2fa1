#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing::detail {

/// The faces of a file, which may be polygons and may come before the points: cut into triangles
/// when all of it was read.
class Faces {
 public:
  /// A face with its line, or 0. Corners that follow an equal one are left out.
  /// Throws InvalidInput for more corners than kMostCorners.
  void add(std::span<const std::uint32_t> corners, std::uint32_t line);
  /// A strip: each corner from the third on makes a triangle with the two before it.
  void add_strip(std::span<const std::uint32_t> corners, std::uint32_t line);

  std::size_t count() const { return lines_.size(); }
  std::span<const std::uint32_t> corners(std::size_t face) const {
    return std::span(corners_).subspan(start_[face], start_[face + 1] - start_[face]);
  }
  std::uint32_t line(std::size_t face) const { return lines_[face]; }

  /// Cuts them; corners must be below the number of points. Adds the notes.
  void finish(SurfaceFile& file) const;

 private:
  std::vector<std::uint32_t> corners_;
  std::vector<std::size_t> start_{0};
  std::vector<std::uint32_t> lines_;
  std::size_t strips_ = 0;
};

/// "1 point", "2 points".
std::string counted(std::size_t count, std::string_view one, std::string_view many);

/// The cells of a file that may have faces, tetrahedra and what lies on lines: a tetrahedral mesh
/// if there is a tetrahedron, else a surface.
class Cells {
 public:
  void add_face(std::span<const std::uint32_t> corners, std::uint32_t line) {
    faces_.add(corners, line);
  }
  void add_strip(std::span<const std::uint32_t> corners, std::uint32_t line) {
    faces_.add_strip(corners, line);
  }
  void add_tetrahedron(const Tetrahedron& corners, std::uint32_t line) {
    tetrahedra_.push_back(corners);
    tetrahedron_lines_.push_back(line);
  }
  /// Counts a cell of a curved kind, of which the corners were added.
  void add_curved() { ++curved_; }
  /// Counts a point or line, which is not needed.
  void add_left_out() { ++left_out_; }

  /// `format` begins the messages, and the file counts points from `first`.
  /// Throws InvalidInput if a corner is no point.
  MeshFile finish(std::vector<Point> points, SourceLines lines, std::vector<std::string> notes,
                  std::string_view format, std::uint32_t first) const;

 private:
  Faces faces_;
  std::vector<Tetrahedron> tetrahedra_;
  std::vector<std::uint32_t> tetrahedron_lines_;
  std::size_t curved_ = 0, left_out_ = 0;
};

}  // namespace tripus::meshing::detail
