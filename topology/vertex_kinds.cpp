#include "topology/vertex_kinds.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/big_number.hpp"

namespace tripus::topology {
namespace {

/// A sum of angles that are known in floating point only is 0 below this: some hundred terms of
/// size 1, each rounded.
constexpr double kZeroSum = 1e-12;
/// Floating point decides the sign of a sum of this size.
constexpr double kClear = 1e-6;

/// The sum over the edge ends at a vertex of (k_e / 2 pi - 1), in exact arithmetic.
BigRational exact_sum(const std::vector<ConeAngle>& angles) {
  BigRational sum = 0;
  for (const ConeAngle& k : angles) sum += BigRational(k.numerator()) / (2 * k.denominator()) - 1;
  return sum;
}

OrbifoldLink orbifold_link(const VertexLink& link, const std::vector<ConeAngle>& cone_points) {
  OrbifoldLink result;
  result.cone_points = cone_points.size();
  double chi = link.euler_characteristic;
  for (const ConeAngle& k : cone_points) chi += k.radians() / (2 * std::numbers::pi) - 1;
  if (!cone_points.empty() && std::fabs(chi) < kClear) {
    if (std::ranges::all_of(cone_points, &ConeAngle::is_rational)) {
      chi = to_double(exact_sum(cone_points) + link.euler_characteristic);
    } else if (std::fabs(chi) < kZeroSum) {
      chi = 0;
    }
  }
  result.euler_characteristic = chi;
  result.kind = chi < 0    ? VertexKind::kHyperideal
                : chi == 0 ? VertexKind::kIdeal
                           : VertexKind::kFinite;
  return result;
}

}  // namespace

std::string_view to_string(VertexKind kind) {
  switch (kind) {
    case VertexKind::kHyperideal:
      return "geodesic";
    case VertexKind::kIdeal:
      return "cusp";
    case VertexKind::kFinite:
      break;
  }
  return "finite";
}

std::vector<OrbifoldLink> orbifold_links(const Triangulation& triangulation,
                                         std::span<const ConeAngle> cone_angles) {
  std::vector<std::vector<ConeAngle>> cone_points(triangulation.vertex_count());
  if (!all_full(cone_angles)) {
    const std::vector<ConeAngle> angles = completed(cone_angles, triangulation.edge_count());
    for (std::size_t e = 0; e < angles.size(); ++e) {
      if (angles[e].is_full()) continue;
      const EdgeCorner corner = triangulation.corners(e)[0];
      for (const int end : kEdgeEnds[static_cast<std::size_t>(corner.edge())])
        cone_points[triangulation.vertex_class(corner.tetrahedron(), end)].push_back(angles[e]);
    }
  } else if (!cone_angles.empty()) {
    completed(cone_angles, triangulation.edge_count());
  }
  std::vector<OrbifoldLink> links;
  links.reserve(triangulation.vertex_count());
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    links.push_back(orbifold_link(triangulation.link(v), cone_points[v]));
  return links;
}

std::string surface_name(const VertexLink& link) {
  const int chi = link.euler_characteristic;
  if (link.orientable) {
    if (chi == 2) return "a sphere";
    return chi == 0 ? "a torus" : "a surface of genus " + std::to_string(link.genus());
  }
  if (chi == 1) return "a projective plane";
  if (chi == 0) return "a Klein bottle";
  return "a non-orientable surface of Euler characteristic " + std::to_string(chi);
}

std::string link_place(const Triangulation& triangulation, std::size_t vertex) {
  const auto classes = triangulation.vertex_classes();
  const auto first = static_cast<std::size_t>(std::ranges::find(classes, vertex) - classes.begin());
  return "the link of vertex class " + std::to_string(vertex) + " (vertex " +
         std::to_string(first % 4) + " of tetrahedron " + std::to_string(first / 4) + ")";
}

}  // namespace tripus::topology
