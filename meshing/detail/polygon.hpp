#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::detail {

/// More corners than any program gives a face; cutting is quadratic in them.
inline constexpr std::size_t kMostCorners = 10'000;

/// Cuts a polygon of 3 to kMostCorners corners into corners - 2 triangles that run the same way
/// round, the roundest ears first, so that corners in the middle of a side make no flat triangle
/// where that can be helped. The polygon need not be convex or planar; of one that crosses itself
/// the triangles still have its border, but may overlap.
///   sides  [corners] or empty: for each corner a set of lines, as bits, that it lies on but for
///          rounding; two corners on one line are then joined only if they are neighbours
void cut_polygon(const std::vector<Point>& points, std::span<const std::uint32_t> corners,
                 std::vector<Triangle>& triangles, std::span<const std::uint8_t> sides = {});

/// Whether its corners lie in one plane but for rounding to single precision.
bool is_planar(const std::vector<Point>& points, std::span<const std::uint32_t> corners);

/// Of length 1, out of a triangle that runs counterclockwise as seen from there; 0 if it is flat.
Point unit_normal(const Point& a, const Point& b, const Point& c);

}  // namespace tripus::meshing::detail
