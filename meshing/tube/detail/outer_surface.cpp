#include "meshing/tube/detail/outer_surface.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "meshing/predicates.hpp"
#include "meshing/tube/detail/convex_hull.hpp"

namespace tripus::meshing::tube {
namespace {

/// The face of a box that is nearest by signed distance: axis and side (0 low, 1 high).
struct OuterFace {
  int axis = 0, side = 0;
  double value = -std::numeric_limits<double>::infinity();
};

double face_value(const OuterBox& box, const Point& p, int axis, int side) {
  return side == 0 ? box.low[axis] - p[axis] : p[axis] - box.high[axis];
}

OuterFace nearest_face(const OuterBox& box, const Point& p) {
  OuterFace best;
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (const double value = face_value(box, p, axis, side); value > best.value)
        best = {axis, side, value};
  return best;
}

}  // namespace

double OuterSurface::value(const Point& p) const {
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_))
    return distance(p, sphere->center) - sphere->radius;
  if (const auto* box = std::get_if<OuterBox>(&shape_)) return nearest_face(*box, p).value;
  return -std::numeric_limits<double>::infinity();
}

Point OuterSurface::normal(const Point& p) const {
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point d = p - sphere->center;
    return norm(d) > 0 ? unit(d) : Point{0, 0, 1};
  }
  Point n{0, 0, 0};
  if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    const OuterFace face = nearest_face(*box, p);
    n[face.axis] = face.side == 0 ? -1 : 1;
  }
  return n;
}

Point OuterSurface::exit_point(const Point& from, const Point& to) const {
  const Point d = unit(to - from);
  double t = 0;
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point o = from - sphere->center;
    const double b = dot(o, d), c = dot(o, o) - sphere->radius * sphere->radius;
    t = -b + std::sqrt(std::max(b * b - c, 0.0));
  } else if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    t = std::numeric_limits<double>::infinity();
    for (int k = 0; k < 3; ++k)
      if (d[k] != 0) t = std::min(t, ((d[k] > 0 ? box->high[k] : box->low[k]) - from[k]) / d[k]);
  }
  return from + t * d;
}

double OuterSurface::distance_from_rim(const Point& p) const {
  const auto* box = std::get_if<OuterBox>(&shape_);
  double least = std::numeric_limits<double>::infinity();
  if (box == nullptr) return least;
  const OuterFace nearest = nearest_face(*box, p);
  for (int axis = 0; axis < 3; ++axis)
    for (int side = 0; side < 2; ++side)
      if (axis != nearest.axis || side != nearest.side)
        least = std::min(least, -face_value(*box, p, axis, side));
  return least;
}

Bounds OuterSurface::bounds() const {
  Bounds result;
  if (const auto* sphere = std::get_if<OuterSphere>(&shape_)) {
    const Point r{sphere->radius, sphere->radius, sphere->radius};
    result.add(sphere->center - r);
    result.add(sphere->center + r);
  } else if (const auto* box = std::get_if<OuterBox>(&shape_)) {
    result.add(box->low);
    result.add(box->high);
  }
  return result;
}

namespace {

/// A first corner of the sphere's polyhedron stays so far from an opening, in its radii.
constexpr double kFirstCornerAway = 3;

/// The polyhedron of a sphere is refined so often; each time, what is cut off by a facet becomes a
/// quarter as high or less.
constexpr int kMostRefinements = 40;

using Facets = std::vector<Triangle>;

std::vector<Point> icosahedron() {
  const double g = std::numbers::phi, n = std::sqrt(1 + g * g);
  std::vector<Point> corners;
  for (const double s : {-1.0, 1.0})
    for (const double t : {-g, g}) {
      corners.push_back({0, s / n, t / n});
      corners.push_back({s / n, t / n, 0});
      corners.push_back({t / n, 0, s / n});
    }
  return corners;
}

class SpherePolyhedron {
 public:
  SpherePolyhedron(SurfaceMesh& mesh, const OuterSurface& outer,
                   const std::vector<Opening>& openings)
      : mesh_(mesh), openings_(openings) {
    const Bounds bounds = outer.bounds();
    center_ = bounds.center();
    radius_ = 0.5 * (bounds.high[0] - bounds.low[0]);
    std::vector<bool> on_it(mesh.points.size());
    for (const Opening& opening : openings)
      for (const std::uint32_t v : opening) on_it[v] = true;
    for (std::uint32_t v = 0; v < mesh.points.size(); ++v)
      (on_it[v] ? corners_ : inner_).push_back(v);
  }

  bool add() {
    for (const Point& corner : icosahedron())
      if (const Point p = center_ + radius_ * corner; far_from_openings(p)) add_corner(p);
    ConvexHull hull(mesh_.points, corners_);
    for (int round = 0; round < kMostRefinements; ++round) {
      // The one that an inner point is outside of is refined by the point of the sphere above it.
      std::vector<Point> tops;
      for (const Triangle& facet : hull.facets())
        if (!all_inside(facet)) tops.push_back(top_of(facet));
      if (tops.empty()) {
        Facets facets = hull.facets();
        if (!take_out(facets, openings_)) return false;
        mesh_.triangles.insert(mesh_.triangles.end(), facets.begin(), facets.end());
        return true;
      }
      for (const Point& top : tops) {
        add_corner(top);
        if (hull.add(mesh_.points, corners_.back())) continue;
        corners_.pop_back();  // it was there already
        mesh_.points.pop_back();
      }
    }
    return false;
  }

 private:
  void add_corner(const Point& p) {
    corners_.push_back(std::uint32_t(mesh_.points.size()));
    mesh_.points.push_back(p);
  }

  bool far_from_openings(const Point& p) const {
    return std::all_of(openings_.begin(), openings_.end(), [&](const Opening& opening) {
      const Point &a = mesh_.points[opening[0]], &b = mesh_.points[opening[1]];
      return distance(p, a) > kFirstCornerAway * distance(a, b);
    });
  }

  bool all_inside(const Triangle& facet) const {
    const auto& p = mesh_.points;
    return std::all_of(inner_.begin(), inner_.end(), [&](std::uint32_t v) {
      return orientation(p[facet[0]], p[facet[1]], p[facet[2]], p[v]) < 0;
    });
  }

  Point top_of(const Triangle& facet) const {
    const auto& p = mesh_.points;
    return center_ + radius_ * unit(area_vector(p[facet[0]], p[facet[1]], p[facet[2]]));
  }

  SurfaceMesh& mesh_;
  const std::vector<Opening>& openings_;
  Point center_{};
  double radius_ = 0;
  std::vector<std::uint32_t> corners_, inner_;
};

/// One face of a box: the Delaunay triangulation of its corners and its openings, which are
/// triangles of that as no other point lies in the circle around one. It is the lower side of a
/// hull: the points lifted to a paraboloid, and one point far above.
bool add_box_face(SurfaceMesh& mesh, std::size_t axis, bool high,
                  const std::array<std::uint32_t, 4>& corners,
                  const std::vector<Opening>& openings) {
  const std::size_t u = (axis + 1) % 3, v = (axis + 2) % 3;
  std::vector<std::uint32_t> names(corners.begin(), corners.end());
  for (const Opening& opening : openings) names.insert(names.end(), opening.begin(), opening.end());
  const Point middle = 0.5 * (mesh.points[corners[0]] + mesh.points[corners[3]]);
  std::vector<Point> lifted;
  std::vector<std::uint32_t> numbers;
  double top = 0;
  for (const std::uint32_t name : names) {
    const double x = mesh.points[name][u] - middle[u], y = mesh.points[name][v] - middle[v];
    numbers.push_back(std::uint32_t(lifted.size()));
    lifted.push_back({mesh.points[name][u], mesh.points[name][v], x * x + y * y});
    top = std::max(top, lifted.back()[2]);
  }
  const auto apex = std::uint32_t(lifted.size());
  numbers.push_back(apex);
  lifted.push_back({middle[u], middle[v], 4 * top});
  Facets facets;
  const ConvexHull hull(lifted, numbers);
  for (Triangle f : hull.facets()) {
    if (std::find(f.begin(), f.end(), apex) != f.end()) continue;
    // From below: clockwise in u, v.
    if (high) std::swap(f[1], f[2]);
    facets.push_back({names[f[0]], names[f[1]], names[f[2]]});
  }
  if (facets.size() != 2 + 2 * 3 * openings.size()) return false;  // of all points
  if (!take_out(facets, openings)) return false;
  mesh.triangles.insert(mesh.triangles.end(), facets.begin(), facets.end());
  return true;
}

bool add_box(SurfaceMesh& mesh, const Bounds& box, const std::vector<Opening>& openings) {
  const auto first = std::uint32_t(mesh.points.size());
  for (std::uint32_t corner = 0; corner < 8; ++corner) {
    Point p;
    for (std::size_t k = 0; k < 3; ++k) p[k] = (corner >> k & 1u) ? box.high[k] : box.low[k];
    mesh.points.push_back(p);
  }
  std::size_t used = 0;
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool high : {false, true}) {
      const double level = high ? box.high[axis] : box.low[axis];
      std::vector<Opening> here;
      for (const Opening& opening : openings)
        if (std::all_of(opening.begin(), opening.end(),
                        [&](std::uint32_t v) { return mesh.points[v][axis] == level; }))
          here.push_back(opening);
      used += here.size();
      std::array<std::uint32_t, 4> corners;
      for (std::uint32_t i = 0; i < 4; ++i)
        corners[i] = first + ((high ? 1u : 0u) << axis) + ((i & 1u) << (axis + 1) % 3) +
                     ((i >> 1) << (axis + 2) % 3);
      if (!add_box_face(mesh, axis, high, corners, here)) return false;
    }
  return used == openings.size();
}

}  // namespace

bool add_outer_polyhedron(SurfaceMesh& mesh, const OuterSurface& outer,
                          const std::vector<Opening>& openings) {
  if (outer.is_sphere()) return SpherePolyhedron(mesh, outer, openings).add();
  return add_box(mesh, outer.bounds(), openings);
}

}  // namespace tripus::meshing::tube
