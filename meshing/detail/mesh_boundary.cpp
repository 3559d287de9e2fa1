#include "meshing/detail/mesh_boundary.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "base/stop.hpp"
#include "base/tolerances.hpp"
#include "meshing/detail/triangle_tree.hpp"
#include "meshing/predicates.hpp"
#include "meshing/self_intersection.hpp"

namespace tripus::meshing::detail {
namespace {

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

class PointSets {
 public:
  explicit PointSets(std::size_t count) : parent_(count) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t root(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) { parent_[root(i)] = root(j); }

 private:
  std::vector<std::uint32_t> parent_;
};

/// Euler characteristics of the components, doubled, each at the root of its points.
std::map<std::uint32_t, long> doubled_characteristics(const std::vector<Triangle>& triangles,
                                                      PointSets& sets, std::size_t point_count) {
  std::vector<bool> used(point_count);
  for (const Triangle& t : triangles) {
    for (const std::uint32_t v : t) used[v] = true;
    sets.join(t[0], t[1]);
    sets.join(t[1], t[2]);
  }
  std::map<std::uint32_t, long> result;
  for (std::uint32_t v = 0; v < point_count; ++v)
    if (used[v]) result[sets.root(v)] += 2;
  for (const Triangle& t : triangles) --result[sets.root(t[0])];
  return result;
}

/// Whether every side is there once in each direction, and the triangles at a point form one fan.
bool is_closed_manifold(const std::vector<Triangle>& triangles, std::size_t point_count) {
  struct Side {
    std::uint32_t from, to, triangle;
  };
  std::vector<Side> sides;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k)
      sides.push_back({triangles[t][k], triangles[t][(k + 1) % 3], t});
  const auto before = [](const Side& a, const Side& b) {
    return a.from != b.from ? a.from < b.from : a.to < b.to;
  };
  std::sort(sides.begin(), sides.end(), before);
  PointSets corners(3 * triangles.size());
  const auto corner = [&](std::uint32_t t, std::uint32_t v) {
    return 3 * t + (triangles[t][0] == v ? 0u : triangles[t][1] == v ? 1u : 2u);
  };
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (i > 0 && !before(sides[i - 1], sides[i])) return false;
    const Side wanted{sides[i].to, sides[i].from, 0};
    const auto back = std::lower_bound(sides.begin(), sides.end(), wanted, before);
    if (back == sides.end() || before(wanted, *back)) return false;
    for (const std::uint32_t v : {wanted.from, wanted.to})
      corners.join(corner(sides[i].triangle, v), corner(back->triangle, v));
  }
  std::vector<std::uint32_t> fan(point_count, 0xffffffff);
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t& first = fan[triangles[t][k]];
      const std::uint32_t root = corners.root(3 * t + k);
      if (first == 0xffffffff) first = root;
      if (first != root) return false;
    }
  return true;
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
std::map<std::uint32_t, double> volumes(const SurfaceMesh& mesh, PointSets& sets) {
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
  PointSets now(boundary.points.size()), then(surface.points.size());
  const auto found = doubled_characteristics(boundary.triangles, now, boundary.points.size());
  const auto wanted = doubled_characteristics(surface.triangles, then, surface.points.size());
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
  const bool good = is_closed_manifold(boundary.triangles, boundary.points.size()) &&
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
