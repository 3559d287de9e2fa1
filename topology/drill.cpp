#include "topology/drill.hpp"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/error.hpp"

// A face ABC with the edge AB is opened to a pillow with a vertex M inside, and in that the face
// ABM to a pillow with a vertex P inside, made of two tetrahedra ABMP with the common face ABP and
// a ball between their faces BMP and AMP. An arc from A to B runs through the ball. When it
// collapses, the ball becomes flat, and of each tetrahedron BMP is glued to AMP, hence AM to BM:
// these are two edges, since M is a vertex of its own. (C may not do for M: AC and BC may be one
// edge.)

namespace tripus::topology {
namespace {

/// Labels a, b, c for A, B, C, d for M; in the inner tetrahedra d for M and c for P. In every
/// second one a and b are exchanged, which makes every gluing odd.
void drill(Gluings& gluings, EdgePlace place) {
  const auto [a, b] = kEdgeEnds[static_cast<std::size_t>(place.edge)];
  const auto [c, d] = kEdgeEnds[static_cast<std::size_t>(5 - place.edge)];
  const TetrahedronIndex t = place.tetrahedron, other = gluings.neighbour(t, d);
  const Perm4 old = gluings.gluing(t, d);
  const auto first = static_cast<TetrahedronIndex>(gluings.tetrahedron_count());
  const TetrahedronIndex second = first + 1, inner = first + 2, innermost = first + 3;
  gluings.resize(innermost + std::size_t{1});
  std::array<int, 4> images{0, 1, 2, 3};
  std::swap(images[static_cast<std::size_t>(a)], images[static_cast<std::size_t>(b)]);
  const Perm4 swapped = Perm4::from_images(images[0], images[1], images[2], images[3]);
  gluings.glue(t, d, first, swapped);
  gluings.glue(first, a, second, swapped);
  gluings.glue(first, b, second, swapped);
  gluings.glue(second, d, other, old);
  gluings.glue(first, c, inner, swapped);
  gluings.glue(inner, d, innermost, swapped);
  gluings.glue(innermost, c, second, swapped);
  gluings.glue(inner, a, inner, swapped);
  gluings.glue(innermost, a, innermost, swapped);
}

}  // namespace

Gluings drilled(const Gluings& closed, std::span<const EdgePlace> edges) {
  Gluings gluings = closed;
  if (edges.empty()) return gluings;
  const Triangulation triangulation(closed);
  std::set<std::uint32_t> taken;
  for (const EdgePlace& place : edges) {
    if (place.tetrahedron >= closed.tetrahedron_count() || place.edge < 0 || place.edge > 5)
      throw InvalidInput("there is no edge " + std::to_string(place.edge) + " of tetrahedron " +
                         std::to_string(place.tetrahedron) + " to be drilled");
    const auto edge = triangulation.edge_class(place.tetrahedron, place.edge);
    if (!taken.insert(static_cast<std::uint32_t>(edge)).second)
      throw InvalidInput("edge class " + std::to_string(edge) + " is to be drilled twice");
    drill(gluings, place);
  }
  return gluings;
}

std::vector<EdgePlace> places_to_drill(const Triangulation& triangulation,
                                       std::span<const std::size_t> edge_classes,
                                       std::span<const ConeAngle> cone_angles) {
  std::vector<EdgePlace> places;
  for (const std::size_t e : edge_classes) {
    if (e >= triangulation.edge_count())
      throw InvalidInput("there is no edge class " + std::to_string(e) + "; there are " +
                         std::to_string(triangulation.edge_count()) + ", from 0 on");
    const EdgeCorner corner = triangulation.corners(e)[0];
    places.push_back({static_cast<TetrahedronIndex>(corner.tetrahedron()), corner.edge()});
  }
  for (std::size_t e = 0; e < cone_angles.size(); ++e) {
    if (cone_angles[e].is_full() || std::ranges::find(edge_classes, e) != edge_classes.end())
      continue;
    throw InvalidInput("edge class " + std::to_string(e) + " has the cone order " +
                       cone_angles[e].order_text() +
                       " and would lose it: drill it too, or leave its label away");
  }
  return places;
}

}  // namespace tripus::topology
