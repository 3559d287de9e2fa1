#include "meshing/self_intersection.hpp"

#include <algorithm>

#include "base/stop.hpp"
#include "meshing/detail/triangle_tree.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing {
namespace {

using Corners = std::array<const Point*, 3>;

Corners corners_of(const SurfaceMesh& mesh, const Triangle& triangle) {
  return {&mesh.points[triangle[0]], &mesh.points[triangle[1]], &mesh.points[triangle[2]]};
}

bool meets(const Point& p, const Point& q, const Corners& t) {
  return segment_meets_triangle(p, q, *t[0], *t[1], *t[2]);
}

/// All corners of `other` strictly on one side of the plane of `t`.
bool is_beside(const Corners& t, const Corners& other) {
  const int first = orientation(*t[0], *t[1], *t[2], *other[0]);
  return first != 0 && orientation(*t[0], *t[1], *t[2], *other[1]) == first &&
         orientation(*t[0], *t[1], *t[2], *other[2]) == first;
}

/// Without common corners: one of the six edges meets the other triangle.
bool apart_cross(const Corners& s, const Corners& t) {
  if (is_beside(s, t) || is_beside(t, s)) return false;
  for (std::size_t i = 0; i < 3; ++i)
    if (meets(*s[i], *s[(i + 1) % 3], t) || meets(*t[i], *t[(i + 1) % 3], s)) return true;
  return false;
}

/// With one common corner: what they share beyond it ends on the edge opposite to it of one of
/// them.
bool at_corner_cross(const Corners& s, std::size_t i, const Corners& t, std::size_t j) {
  return meets(*s[(i + 1) % 3], *s[(i + 2) % 3], t) || meets(*t[(j + 1) % 3], *t[(j + 2) % 3], s);
}

/// With a common edge: only if they lie in one plane, on one side of it.
bool at_edge_cross(const Corners& s, std::size_t i, const Corners& t, std::size_t j) {
  const Point &a = *s[(i + 1) % 3], &b = *s[(i + 2) % 3];  // corner i of s, j of t are not shared
  if (orientation(a, b, *s[i], *t[j]) != 0) return false;
  const int axis = projection_axis(a, b, *s[i]);
  return projected_orientation(a, b, *s[i], axis) == projected_orientation(a, b, *t[j], axis);
}

}  // namespace

bool triangles_cross(const SurfaceMesh& mesh, std::size_t s, std::size_t t) {
  const Triangle &left = mesh.triangles[s], &right = mesh.triangles[t];
  std::size_t shared = 0, shared_left = 0, shared_right = 0;  // sums of the positions
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j)
      if (left[i] == right[j]) {
        ++shared;
        shared_left += i;
        shared_right += j;
      }
  const Corners a = corners_of(mesh, left), b = corners_of(mesh, right);
  if (shared == 0) return apart_cross(a, b);
  if (shared == 1) return at_corner_cross(a, shared_left, b, shared_right);
  return at_edge_cross(a, 3 - shared_left, b, 3 - shared_right);
}

std::optional<std::array<std::uint32_t, 2>> first_self_intersection(const SurfaceMesh& mesh,
                                                                    const Stop& stop) {
  const detail::TriangleTree tree(mesh);
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t s = 0; s < count; ++s) {
    throw_if_stopped(stop);
    const detail::Box box = detail::box_of(mesh, s);
    std::uint32_t first = count;
    tree.for_each([&](const detail::Box& other) { return box.meets(other); },
                  [&](std::uint32_t t) {
                    if (t > s && t < first && triangles_cross(mesh, s, t)) first = t;
                    return true;
                  });
    if (first < count) return {{s, first}};
  }
  return std::nullopt;
}

}  // namespace tripus::meshing
