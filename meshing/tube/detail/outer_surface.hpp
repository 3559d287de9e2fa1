#pragma once

#include <optional>
#include <variant>
#include <vector>

#include "meshing/tube/detail/vector3.hpp"
#include "meshing/tube/spatial_graph.hpp"

namespace tripus::meshing::tube {

/// The outer surface as a function of space: a sphere, a box, or nothing.
class OuterSurface {
 public:
  OuterSurface() = default;
  explicit OuterSurface(const OuterSphere& sphere) : shape_(sphere) {}
  explicit OuterSurface(const OuterBox& box) : shape_(box) {}

  bool exists() const { return shape_.index() != 0; }
  bool is_sphere() const { return std::holds_alternative<OuterSphere>(shape_); }

  /// At most the distance to the surface, negative inside; convex, changes no faster than the
  /// place.
  double value(const Point& p) const;

  /// Unit vector along which `value` grows.
  Point normal(const Point& p) const;

  /// The point after `from`, which is inside, where the ray through `to` leaves.
  Point exit_point(const Point& from, const Point& to) const;

  /// How far inside a point of the surface is with respect to the other faces of the box; infinite
  /// for a sphere.
  double distance_from_rim(const Point& p) const;

  Bounds bounds() const;

 private:
  std::variant<NoOuter, OuterSphere, OuterBox> shape_;
};

/// A triangle of points in the outer surface where a pipe comes out, counterclockwise from outside.
using Opening = Triangle;

/// The outer surface in few triangles: convex, with its corners on the sphere or the box, and with
/// all points that are there already, but for those of the openings, strictly inside. The triangles
/// of the openings are left out; the others face outwards and are added, as new points are.
/// Says no if an opening is too small, beside the whole, for what doubles resolve.
bool add_outer_polyhedron(SurfaceMesh& mesh, const OuterSurface& outer,
                          const std::vector<Opening>& openings);

}  // namespace tripus::meshing::tube
