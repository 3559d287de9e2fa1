#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "meshing/surface_mesh.hpp"

namespace tripus::meshing::tube {

/// The convex hull of points that are added one after the other, in triangles that face outwards.
/// Exact for the coordinates as they are. No three of the points may be collinear; more than three
/// in a plane are fine. A point costs time in proportion to the number of facets.
class ConvexHull {
 public:
  /// Of the named points; the names are those in the facets. Without facets if all lie in a plane.
  ConvexHull(const std::vector<Point>& points, const std::vector<std::uint32_t>& names);

  /// Says no, and changes nothing, if the point lies in the hull. `points` is the array of the
  /// constructor, which may have grown.
  bool add(const std::vector<Point>& points, std::uint32_t name);

  const std::vector<Triangle>& facets() const { return facets_; }

 private:
  std::vector<Triangle> facets_;
  std::vector<Triangle> kept_;                                  // scratch space
  std::vector<std::array<std::uint32_t, 2>> sides_, backward_;  // scratch space
};

/// Takes the triangles out of the facets, whatever corner they begin with; says no if one is no
/// facet.
bool take_out(std::vector<Triangle>& facets, const std::vector<Triangle>& triangles);

}  // namespace tripus::meshing::tube
