#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "meshing/detail/triangle_tree.hpp"

namespace tripus::meshing::detail {

/// Which components of a closed surface without self-intersections enclose a point: those that a
/// ray from it crosses an odd number of times. Exact: a ray through an edge or a corner, or along a
/// triangle, is replaced by another.
class PointLocation {
 public:
  /// Both arguments must outlive this.
  PointLocation(const SurfaceMesh& mesh, const std::vector<std::uint32_t>& component_of);

  /// The components around p, in order, `without` left out; p may lie on that one alone.
  /// Nothing if p lies on another.
  std::optional<std::vector<std::uint32_t>> around(const Point& p, std::uint32_t without) const;

 private:
  enum class Ray { kDone, kUnlucky, kOnSurface };
  Ray cast(const Point& p, const Point& q, std::uint32_t without,
           std::vector<std::uint32_t>& crossed) const;

  const SurfaceMesh& mesh_;
  const std::vector<std::uint32_t>& component_of_;
  TriangleTree tree_;
};

}  // namespace tripus::meshing::detail
