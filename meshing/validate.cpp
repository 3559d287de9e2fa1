#include "meshing/validate.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "base/tolerances.hpp"
#include "meshing/detail/connectivity.hpp"
#include "meshing/detail/places.hpp"
#include "meshing/detail/point_location.hpp"
#include "meshing/predicates.hpp"

namespace tripus::meshing {
namespace {

using detail::Connectivity;
using detail::Places;

/// More points or triangles than this would overflow the numbers of sides.
constexpr std::size_t kMostTriangles = std::size_t{1} << 30;

void require_corners(const SurfaceMesh& mesh, const Places& places) {
  if (mesh.triangles.empty())
    throw InvalidInput("the surface is empty: it has " + std::to_string(mesh.points.size()) +
                       " points and no triangles");
  if (mesh.triangles.size() > kMostTriangles || mesh.points.size() > kMostTriangles)
    throw InvalidInput("the surface has more than 2^30 triangles or points");
  std::vector<bool> used(mesh.points.size(), false);
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto& [a, b, c] = mesh.triangles[t];
    for (const std::uint32_t corner : mesh.triangles[t]) {
      if (corner >= mesh.points.size())
        throw InvalidInput(places.cell(t) + " has the corner " + std::to_string(corner) +
                           ", but there are only " + std::to_string(mesh.points.size()) +
                           " points, numbered from 0");
      used[corner] = true;
    }
    if (a == b || b == c || c == a)
      throw InvalidInput(places.cell(t) + " is degenerate: it has " + places.point(a == b ? a : c) +
                         " as two of its corners; remove it");
  }
  detail::require_coordinates(mesh.points, places);
  detail::require_points_used(used, places);
}

void require_proper_triangles(const SurfaceMesh& mesh, const Places& places) {
  std::size_t count = 0, first = 0;
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const auto& [a, b, c] = mesh.triangles[t];
    if (projection_axis(mesh.points[a], mesh.points[b], mesh.points[c]) >= 0) continue;
    ++count;
    first = t;
  }
  if (count > 0)
    throw InvalidInput(places.cell(first) + " is degenerate: its corners lie on a line" +
                       detail::in_all(count) + "; remesh the surface there");
}

void require_different_triangles(const SurfaceMesh& mesh, const Places& places) {
  std::vector<std::array<std::uint32_t, 4>> sorted;
  sorted.reserve(mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    Triangle corners = mesh.triangles[t];
    std::sort(corners.begin(), corners.end());
    sorted.push_back({corners[0], corners[1], corners[2], t});
  }
  std::sort(sorted.begin(), sorted.end());
  for (std::size_t i = 1; i < sorted.size(); ++i)
    if (std::equal(sorted[i].begin(), sorted[i].begin() + 3, sorted[i - 1].begin()))
      throw InvalidInput(places.cell(sorted[i - 1][3]) + " and " + places.cell(sorted[i][3]) +
                         " have the same corners; remove one of them");
}

/// Whether reading cut the face of the file that a triangle is a part of.
bool is_part(const SourceLines& lines, std::size_t t) {
  const auto& numbers = lines.cell_numbers;
  if (t >= numbers.size()) return false;
  return (t > 0 && numbers[t - 1] == numbers[t]) ||
         (t + 1 < numbers.size() && numbers[t + 1] == numbers[t]);
}

void require_no_crossing(const SurfaceMesh& mesh, const Places& places, const SourceLines& lines,
                         const Stop& stop) {
  const auto pair = first_self_intersection(mesh, stop);
  if (!pair) return;
  const Triangle& t = mesh.triangles[(*pair)[0]];
  Point centre{};
  for (const std::uint32_t corner : t)
    for (std::size_t k = 0; k < 3; ++k) centre[k] += mesh.points[corner][k] / 3;
  char where[96];
  std::snprintf(where, sizeof where, "(%.4g, %.4g, %.4g)", centre[0], centre[1], centre[2]);
  throw InvalidInput("the surface intersects itself: " + places.cell((*pair)[0]) + " and " +
                     places.cell((*pair)[1]) + " meet, near " + where +
                     (is_part(lines, (*pair)[0]) || is_part(lines, (*pair)[1])
                          ? "; the face was cut into triangles, since it has more than three "
                            "corners: cut it where it was made, where it is not planar"
                          : "; move the sheets apart or take their union first"));
}

void turn(Triangle& t) { std::swap(t[1], t[2]); }

/// Six times the volume within each component: the sign says whether its triangles face outwards.
std::vector<double> signed_volumes(const Region& region) {
  std::vector<double> volumes(region.components.size(), 0);
  const auto& [points, triangles] = region.surface;
  std::vector<Point> origin(region.components.size());
  for (std::size_t c = 0; c < origin.size(); ++c)
    origin[c] = points[triangles[region.components[c].first_triangle][0]];
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t component = region.component_of[t];
    std::array<Point, 3> v;
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t k = 0; k < 3; ++k)
        v[i][k] = points[triangles[t][i]][k] - origin[component][k];
    volumes[component] += v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) +
                          v[0][1] * (v[1][2] * v[2][0] - v[1][0] * v[2][2]) +
                          v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
  }
  return volumes;
}

void orient(Region& region, const Connectivity& connectivity) {
  auto& triangles = region.surface.triangles;
  for (std::size_t t = 0; t < triangles.size(); ++t)
    if (connectivity.turned[t]) turn(triangles[t]);
  const std::vector<double> volumes = signed_volumes(region);
  std::vector<std::size_t> turned(region.components.size(), 0);
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    const std::uint32_t component = region.component_of[t];
    const bool inside_out = volumes[component] < 0;
    if (inside_out) turn(triangles[t]);
    turned[component] += inside_out != connectivity.turned[t];
  }
  // A whole component that faces inwards is as good as one that faces outwards.
  for (std::size_t c = 0; c < turned.size(); ++c)
    region.turned += std::min(turned[c], region.components[c].triangle_count - turned[c]);
}

void count_components(Region& region, const Connectivity& connectivity) {
  region.component_of = connectivity.component_of;
  region.components.resize(connectivity.component_count);
  std::vector<std::size_t> points(connectivity.component_count, 0);
  std::vector<bool> seen(region.surface.points.size(), false);
  for (std::size_t t = 0; t < region.component_of.size(); ++t) {
    SurfaceComponent& component = region.components[region.component_of[t]];
    if (component.triangle_count++ == 0) component.first_triangle = static_cast<std::uint32_t>(t);
    for (const std::uint32_t corner : region.surface.triangles[t]) {
      if (seen[corner]) continue;
      seen[corner] = true;
      ++points[region.component_of[t]];
    }
  }
  for (std::size_t c = 0; c < points.size(); ++c) {
    // Three sides a triangle, each shared by two: V - E + F = V - F/2 = 2 - 2 genus.
    const auto characteristic = static_cast<std::int64_t>(points[c]) -
                                static_cast<std::int64_t>(region.components[c].triangle_count / 2);
    region.components[c].genus = static_cast<int>((2 - characteristic) / 2);
  }
}

std::string component_name(const Region& region, std::uint32_t c, const Places& places) {
  return "component " + std::to_string(c) + " (with " +
         places.cell(region.components[c].first_triangle) + ")";
}

void require_nesting(Region& region, const Places& places) {
  const auto count = static_cast<std::uint32_t>(region.components.size());
  if (count == 1) return;
  const detail::PointLocation location(region.surface, region.component_of);
  std::vector<std::vector<std::uint32_t>> around(count);
  std::vector<std::uint32_t> outer;
  for (std::uint32_t c = 0; c < count; ++c) {
    const Triangle& t = region.surface.triangles[region.components[c].first_triangle];
    around[c] = location.around(region.surface.points[t[0]], c).value();
    if (around[c].empty()) outer.push_back(c);
  }
  if (outer.size() != 1)
    throw InvalidInput("wrong nesting: " + component_name(region, outer[0], places) + " and " +
                       component_name(region, outer[1], places) +
                       " lie outside each other; one component must enclose all others: give each "
                       "solid in a file of its own");
  region.outermost = outer[0];
  for (std::uint32_t c = 0; c < count; ++c) {
    if (around[c].size() < 2) continue;
    const std::uint32_t hole = around[c][0] != outer[0] ? around[c][0] : around[c][1];
    throw InvalidInput("wrong nesting: " + component_name(region, c, places) + " lies within " +
                       component_name(region, hole, places) +
                       ", which is a hole; all but the outermost component are holes, and holes "
                       "must lie beside each other: leave out one of the two");
  }
}

}  // namespace

Region require_valid(SurfaceMesh mesh, const SourceLines& lines, const Stop& stop) {
  const Places places(lines, "triangle");
  require_corners(mesh, places);
  detail::require_points_different(mesh.points, places);
  require_proper_triangles(mesh, places);
  require_different_triangles(mesh, places);
  throw_if_stopped(stop);
  const Connectivity connectivity = detail::require_closed_manifold(
      mesh.triangles, mesh.points.size(), [&](std::size_t t) { return places.cell(t); }, places);
  require_no_crossing(mesh, places, lines, stop);
  Region region;
  region.surface = std::move(mesh);
  count_components(region, connectivity);
  orient(region, connectivity);
  require_nesting(region, places);
  return region;
}

Point point_in_hole(const Region& region, std::uint32_t hole) {
  const detail::PointLocation location(region.surface, region.component_of);
  const auto& [points, triangles] = region.surface;
  std::vector<std::uint32_t> own;
  for (std::uint32_t t = 0; t < triangles.size(); ++t)
    if (region.component_of[t] == hole) own.push_back(t);
  // From the middle of some triangles inwards, by less and less of their size.
  constexpr std::size_t kTriangles = 64;
  const std::size_t step = std::max<std::size_t>(1, own.size() / kTriangles);
  const std::vector<std::uint32_t> wanted = hole < region.outermost
                                                ? std::vector{hole, region.outermost}
                                                : std::vector{region.outermost, hole};
  for (double depth = 0.5; depth > tolerance::kThinnestHole; depth /= 4) {
    for (std::size_t i = 0; i < own.size(); i += step) {
      const Triangle& t = triangles[own[i]];
      const Point &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
      Point u, v, p;
      for (std::size_t k = 0; k < 3; ++k) u[k] = b[k] - a[k], v[k] = c[k] - a[k];
      const Point n{u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2],
                    u[0] * v[1] - u[1] * v[0]};
      // The normal is as long as twice the area: its root is the size of the triangle.
      const double scale = depth / std::sqrt(std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]));
      for (std::size_t k = 0; k < 3; ++k) p[k] = (a[k] + b[k] + c[k]) / 3 - n[k] * scale;
      if (!std::all_of(p.begin(), p.end(), in_exact_range)) continue;
      if (location.around(p, UINT32_MAX) == wanted) return p;
    }
  }
  throw Unsupported("no point was found in the hole that component " + std::to_string(hole) +
                    " encloses; it is too thin");
}

}  // namespace tripus::meshing
