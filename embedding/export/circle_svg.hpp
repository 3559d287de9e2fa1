#pragma once

#include <span>
#include <string>

#include "embedding/universal_cover.hpp"
#include "geometry/circle_packing.hpp"

namespace tripus::embedding {

/// The circles at infinity of one cell, in a common picture of the plane.
struct CirclePicture {
  geometry::CirclePacking packing;
  std::uint32_t tetrahedron = 0;
};

/// The circles of cells in the paper's place for the root: its first face is the line y = 0, its
/// second a line through 0, its third has radius 1.
///   dihedral_angles  [T] radians
/// Source: docs/theory.md (65) to (70).
std::vector<CirclePicture> circle_pictures(const Embedding& embedding, std::span<const Cell> cells,
                                           std::span<const std::array<double, 6>> dihedral_angles);

/// An SVG document: faces drawn full in the colours of their tetrahedra, truncations dashed. The
/// circles of the first cell are named f1..f4, v1..v4 as in the paper, and are all in the picture.
std::string circles_as_svg(std::span<const CirclePicture> pictures, const std::string& title);

}  // namespace tripus::embedding
