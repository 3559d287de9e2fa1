#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "meshing/detail/faces.hpp"
#include "meshing/formats/read_mesh.hpp"

namespace tripus::meshing::detail {

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
