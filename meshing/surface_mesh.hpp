#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace tripus::meshing {

using Point = std::array<double, 3>;
/// Corners of a triangle, as indices into the points.
using Triangle = std::array<std::uint32_t, 3>;

/// A triangle surface of any number of components, as a file or a generator gives it: nothing is
/// promised but what require_valid (meshing/validate.hpp) checks. Points and triangles are counted
/// from 0 everywhere, whatever the file does.
struct SurfaceMesh {
  std::vector<Point> points;
  std::vector<Triangle> triangles;

  friend bool operator==(const SurfaceMesh&, const SurfaceMesh&) = default;
};

/// Where points and cells stand in the file that they were read from: line numbers from 1, or
/// nothing (binary files, generated meshes). Only for messages.
struct SourceLines {
  std::vector<std::uint32_t> points;
  std::vector<std::uint32_t> cells;  ///< triangles or tetrahedra
  /// Their numbers in the file, where these are others than here; else nothing.
  std::vector<std::uint32_t> point_numbers = {};
  std::vector<std::uint32_t> cell_numbers = {};
};

}  // namespace tripus::meshing
