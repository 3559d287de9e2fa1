#include "topology/simplify/ideal.hpp"

#include <algorithm>

#include "base/stop.hpp"
#include "topology/cone.hpp"
#include "topology/orientation.hpp"
#include "topology/simplify/simplify.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {
namespace {

std::size_t open_face_count(const Gluings& gluings) {
  std::size_t count = 0;
  for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t)
    for (int f = 0; f < 4; ++f) count += gluings.is_open(t, f);
  return count;
}

struct Links {
  std::size_t spheres = 0, others = 0;
};

Links count_links(const Triangulation& triangulation) {
  Links links;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    ++(triangulation.link(v).euler_characteristic == 2 ? links.spheres : links.others);
  return links;
}

}  // namespace

IdealTriangulation ideal_triangulation(const Gluings& gluings, FiniteVertices finite_vertices,
                                       const Stop& stop) {
  IdealTriangulation result;
  result.given = gluings.tetrahedron_count();
  result.coned_faces = open_face_count(gluings);
  result.gluings = result.coned_faces == 0 ? gluings : cone_boundary(gluings);
  if (finite_vertices == FiniteVertices::kKeep || result.given == 0) return result;
  const Links before = count_links(Triangulation(result.gluings));
  if (before.spheres == 0 || before.others == 0) return result;
  SimplifyOptions options;
  options.stop = stop;
  Simplified simplified = simplify(oriented(result.gluings), options);
  result.finite_vertices = before.spheres - count_links(Triangulation(simplified.gluings)).spheres;
  if (result.finite_vertices > 0) result.gluings = std::move(simplified.gluings);
  return result;
}

}  // namespace tripus::topology
