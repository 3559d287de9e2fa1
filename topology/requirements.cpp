#include "topology/requirements.hpp"

#include <string>
#include <vector>

#include "base/error.hpp"
#include "topology/vertex_kinds.hpp"

namespace tripus::topology {
namespace {

bool is_closed(const Triangulation& triangulation) {
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic != 2) return false;
  return true;
}

void require_connected(const Triangulation& triangulation) {
  if (triangulation.is_connected()) return;
  throw InvalidInput("the triangulation has " + std::to_string(triangulation.component_count()) +
                     " components; a metric is found for one connected manifold at a time: "
                     "take each by itself");
}

/// The cone angles at the edge ends of one vertex class that are not 2 pi.
std::vector<ConeAngle> cone_points(const Triangulation& triangulation, std::size_t vertex,
                                   std::span<const ConeAngle> cone_angles) {
  std::vector<ConeAngle> points;
  for (std::size_t e = 0; e < cone_angles.size(); ++e) {
    if (cone_angles[e].is_full()) continue;
    const EdgeCorner corner = triangulation.corners(e)[0];
    for (const int end : kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      if (triangulation.vertex_class(corner.tetrahedron(), end) == vertex)
        points.push_back(cone_angles[e]);
  }
  return points;
}

void require_spherical_link(const Triangulation& triangulation, std::size_t vertex,
                            std::span<const ConeAngle> cone_angles) {
  const VertexLink& link = triangulation.link(vertex);
  if (!link.orientable)
    throw InvalidInput(link_place(triangulation, vertex) + " is " + surface_name(link) +
                       ", the quotient of a sphere by a map without fixed points; such a point is "
                       "not one of a manifold, nor of an orbifold with singular edges: take the "
                       "orientable double cover");
  if (link.euler_characteristic < 2)
    throw InvalidInput(
        link_place(triangulation, vertex) + " is " + surface_name(link) +
        ", which carries no metric of positive curvature, but its cone angles, of more "
        "than 2 pi, ask for one; make them smaller");
  const auto points = cone_points(triangulation, vertex, cone_angles);
  if (points.size() == 1 || (points.size() == 2 && points[0] != points[1]))
    throw InvalidInput(link_place(triangulation, vertex) + " is a sphere with " +
                       (points.size() == 1 ? "one cone point" : "two different cone points") +
                       ", which no metric of constant curvature has; a singular edge cannot end "
                       "at a finite vertex, nor change its cone angle there");
}

void require_parabolic_ends(const Triangulation& triangulation,
                            std::span<const ConeAngle> cone_angles,
                            const std::vector<OrbifoldLink>& links) {
  for (std::size_t e = 0; e < cone_angles.size(); ++e) {
    if (!cone_angles[e].is_parabolic()) continue;
    const EdgeCorner corner = triangulation.corners(e)[0];
    for (const int end : kEdgeEnds[static_cast<std::size_t>(corner.edge())]) {
      const std::size_t vertex = triangulation.vertex_class(corner.tetrahedron(), end);
      if (links[vertex].kind == VertexKind::kHyperideal) continue;
      throw InvalidInput(
          "edge class " + std::to_string(e) + " is parabolic (cone angle 0), but " +
          link_place(triangulation, vertex) + " makes it end at a " +
          std::string(links[vertex].kind == VertexKind::kIdeal ? "cusp" : "finite vertex") +
          "; a parabolic edge runs between geodesic boundary components: drill the "
          "edge out instead, or give it a cone order");
    }
  }
}

void require_orientable_link(const Triangulation& triangulation, std::size_t vertex) {
  const VertexLink& link = triangulation.link(vertex);
  if (!link.orientable)
    throw InvalidInput(link_place(triangulation, vertex) + " is " + surface_name(link) +
                       "; links must be orientable of genus 2 or more: take the orientable "
                       "double cover");
}

/// Links of genus 2 or more; those of Euler characteristic 0 go to `cusp`.
template <class Cusp>
void require_boundary(const Triangulation& triangulation, Cusp&& cusp) {
  require_connected(triangulation);
  if (is_closed(triangulation))
    throw Unsupported(
        "the link of every vertex is a sphere, so the manifold is closed; its metric can be "
        "solved for, but nothing else so far: geodesic boundary needs a link of genus 2 or more");
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const VertexLink& link = triangulation.link(v);
    if (link.euler_characteristic == 2)
      throw InvalidInput(link_place(triangulation, v) +
                         " is a sphere, so this is a finite vertex; simplify first to "
                         "remove it");
    if (link.euler_characteristic == 0) {
      cusp(v);
      continue;
    }
    require_orientable_link(triangulation, v);
  }
}

}  // namespace

void require_solvable(const Triangulation& triangulation, std::span<const ConeAngle> cone_angles) {
  require_connected(triangulation);
  const std::vector<OrbifoldLink> links = orbifold_links(triangulation, cone_angles);
  for (std::size_t v = 0; v < links.size(); ++v) {
    if (links[v].kind != VertexKind::kFinite) continue;
    require_spherical_link(triangulation, v, cone_angles);
  }
  require_parabolic_ends(triangulation, cone_angles, links);
}

void require_geodesic_boundary(const Triangulation& triangulation) {
  require_boundary(triangulation, [&](std::size_t vertex) {
    require_orientable_link(triangulation, vertex);
    throw Unsupported(link_place(triangulation, vertex) +
                      " is a torus; a metric with cusps can be solved for, but for the rest every "
                      "link must have genus 2 or more");
  });
}

void require_boundary_beside_cusps(const Triangulation& triangulation) {
  bool has_boundary = false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    has_boundary = has_boundary || triangulation.link(v).euler_characteristic < 0;
  require_boundary(triangulation, [&](std::size_t vertex) {
    if (has_boundary) return;
    throw Unsupported(link_place(triangulation, vertex) + " is " +
                      surface_name(triangulation.link(vertex)) +
                      ", and so is that of every vertex, or a sphere: without geodesic boundary, "
                      "a link of genus 2 or more, there is nothing here to find");
  });
}

}  // namespace tripus::topology
