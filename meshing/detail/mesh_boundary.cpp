#include <algorithm>
#include <cmath>
#include <map>

#include "base/stop.hpp"
#include "base/tolerances.hpp"
#include "meshing/detail/closed_surface.hpp"
#include "meshing/detail/filling.hpp"
#include "meshing/detail/triangle_tree.hpp"
#include "meshing/predicates.hpp"
#include "meshing/self_intersection.hpp"

namespace tripus::meshing::detail {
namespace {

using topology::DisjointSets;

/// Corners in order, with the face they come from.
struct SortedFace {
  Triangle corners;
  std::uint32_t tetrahedron;
  std::uint32_t opposite;
  friend bool operator<(const SortedFace& a, const SortedFace& b) { return a.corners < b.corners; }
};

/// Of a tetrahedron in positive order, the face without corner f, counterclockwise from outside.
Triangle outward_face(const Tetrahedron& t, std::size_t f) {
  constexpr std::size_t kCorners[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  return {t[kCorners[f][0]], t[kCorners[f][1]], t[kCorners[f][2]]};
}

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Point times(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double inner(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double size_of(const Point& a) { return std::sqrt(inner(a, a)); }

/// Whether p is within `tolerance` of the closed triangle a b c: of its plane, and not further than
/// that beyond one of its sides.
bool lies_on(const Point& p, const Point& a, const Point& b, const Point& c, double tolerance) {
  const Point n = times(minus(b, a), minus(c, a));
  const double area = size_of(n);
  if (!(std::fabs(inner(n, minus(p, a))) <= tolerance * area)) return false;
  const std::array<const Point*, 4> around{&a, &b, &c, &a};
  for (std::size_t k = 0; k < 3; ++k) {
    const Point side = minus(*around[k + 1], *around[k]);
    const double beyond = inner(times(n, side), minus(p, *around[k]));  // negative outside
    if (!(beyond >= -tolerance * area * size_of(side))) return false;
  }
  return true;
}

/// Whether each triangle lies on one of the surface's.
bool all_on_surface(const SurfaceMesh& boundary, const SurfaceMesh& surface) {
  double size = 0;
  for (const Point& p : surface.points)
    for (const double x : p) size = std::fmax(size, std::fabs(x));
  const double tolerance = tolerance::kOnSurface * size;
  const TriangleTree tree(surface);
  for (const Triangle& t : boundary.triangles) {
    Box box = empty_box();
    for (const std::uint32_t v : t) box.include(boundary.points[v]);
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] -= tolerance;
      box.high[k] += tolerance;
    }
    bool found = false;
    tree.for_each([&](const Box& other) { return other.meets(box); },
                  [&](std::uint32_t s) {
                    const Triangle& corners = surface.triangles[s];
                    found = std::all_of(t.begin(), t.end(), [&](std::uint32_t v) {
                      return std::find(corners.begin(), corners.end(), v) != corners.end() ||
                             lies_on(boundary.points[v], surface.points[corners[0]],
                                     surface.points[corners[1]], surface.points[corners[2]],
                                     tolerance);
                    });
                    return !found;
                  });
    if (!found) return false;
  }
  return true;
}

/// Signed volumes that the components bound, six times, each at the root of its points.
std::map<std::uint32_t, double> volumes(const SurfaceMesh& mesh, DisjointSets& sets) {
  std::map<std::uint32_t, double> result;
  for (const Triangle& t : mesh.triangles) {
    const std::uint32_t root = sets.root(t[0]);
    const Point& o = mesh.points[root];
    result[root] += inner(minus(mesh.points[t[0]], o),
                          times(minus(mesh.points[t[1]], o), minus(mesh.points[t[2]], o)));
  }
  return result;
}

/// Moving a component by rounding changes its volume by less than this part, unless it is as thin
/// as that; one that does not run around what it lies on has next to no volume.
constexpr double kSameVolume = 1e-2;

/// Whether the components have the genera and volumes of those that they share points with, one
/// for one. Faces look out of the region, triangles of the surface out of their component.
bool same_components(const SurfaceMesh& boundary, const Region& region) {
  const SurfaceMesh& surface = region.surface;
  DisjointSets now(boundary.points.size()), then(surface.points.size());
  const auto found = doubled_characteristics(boundary.triangles, now);
  const auto wanted = doubled_characteristics(surface.triangles, then);
  if (found.size() != wanted.size()) return false;
  const auto volume_now = volumes(boundary, now), volume_then = volumes(surface, then);
  std::map<std::uint32_t, std::uint32_t> partner;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t)
    for (const std::uint32_t v : surface.triangles[t]) {
      const std::uint32_t here = now.root(v), there = then.root(v);
      const auto place = found.find(here);
      if (place == found.end() || place->second != wanted.at(there)) return false;
      const auto [known, fresh] = partner.emplace(here, there);
      if (known->second != there) return false;
      if (!fresh) continue;
      const double sign = region.component_of[t] == region.outermost ? 1 : -1;
      const double volume = volume_then.at(there);
      if (!(std::fabs(sign * volume_now.at(here) - volume) <= kSameVolume * volume)) return false;
    }
  return partner.size() == found.size();
}

/// Points on the boundary, numbered anew if they are not the surface's.
SurfaceMesh boundary_surface(const TetrahedralMesh& mesh, const std::vector<Triangle>& faces,
                             std::size_t surface_points) {
  SurfaceMesh result;
  result.points.assign(mesh.points.begin(),
                       mesh.points.begin() + static_cast<std::ptrdiff_t>(surface_points));
  result.triangles = faces;
  std::map<std::uint32_t, std::uint32_t> number;
  for (Triangle& t : result.triangles)
    for (std::uint32_t& v : t) {
      if (v < surface_points) continue;
      const auto fresh = static_cast<std::uint32_t>(result.points.size());
      const auto [place, is_new] = number.emplace(v, fresh);
      if (is_new) result.points.push_back(mesh.points[v]);
      v = place->second;
    }
  return result;
}

std::vector<Triangle> sorted_corners(std::vector<Triangle> triangles) {
  for (Triangle& t : triangles) std::sort(t.begin(), t.end());
  std::sort(triangles.begin(), triangles.end());
  return triangles;
}

}  // namespace

std::vector<Triangle> boundary_faces(const TetrahedralMesh& mesh) {
  std::vector<SortedFace> faces;
  faces.reserve(4 * mesh.tetrahedra.size());
  for (std::uint32_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::uint32_t f = 0; f < 4; ++f) {
      Triangle corners = outward_face(mesh.tetrahedra[t], f);
      std::sort(corners.begin(), corners.end());
      faces.push_back({corners, t, f});
    }
  std::sort(faces.begin(), faces.end());
  std::vector<Triangle> once;
  for (std::size_t i = 0, end = 0; i < faces.size(); i = end) {
    while (end < faces.size() && faces[end].corners == faces[i].corners) ++end;
    if (end - i == 1)
      once.push_back(outward_face(mesh.tetrahedra[faces[i].tetrahedron], faces[i].opposite));
  }
  return once;
}

std::string boundary_fault(const TetrahedralMesh& mesh, const Region& region, const Stop& stop) {
  const SurfaceMesh& surface = region.surface;
  if (mesh.points.size() < surface.points.size() ||
      !std::equal(surface.points.begin(), surface.points.end(), mesh.points.begin()))
    return "TetGen moved points of this surface";
  const std::vector<Triangle> faces = boundary_faces(mesh);
  if (sorted_corners(faces) == sorted_corners(surface.triangles)) return "";
  const std::string fault = "TetGen did not keep the boundary of this surface";
  const SurfaceMesh boundary = boundary_surface(mesh, faces, surface.points.size());
  const bool good = manifold_fault(boundary.triangles, boundary.points.size()).empty() &&
                    same_components(boundary, region) && all_on_surface(boundary, surface) &&
                    std::all_of(faces.begin(), faces.end(),
                                [&](const Triangle& t) {
                                  return projection_axis(mesh.points[t[0]], mesh.points[t[1]],
                                                         mesh.points[t[2]]) >= 0;
                                }) &&
                    !first_self_intersection(boundary, stop);
  return good ? "" : fault;
}

}  // namespace tripus::meshing::detail
