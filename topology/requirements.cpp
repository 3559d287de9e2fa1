#include "topology/requirements.hpp"

#include <algorithm>
#include <string>

#include "base/error.hpp"

namespace tripus::topology {
namespace {

std::string place(const Triangulation& triangulation, std::size_t v) {
  const auto classes = triangulation.vertex_classes();
  const auto first = static_cast<std::size_t>(std::ranges::find(classes, v) - classes.begin());
  return "the link of vertex class " + std::to_string(v) + " (vertex " + std::to_string(first % 4) +
         " of tetrahedron " + std::to_string(first / 4) + ")";
}

std::string surface_name(const VertexLink& link) {
  if (link.euler_characteristic == 1) return "a projective plane";
  if (link.euler_characteristic == 0) return "a Klein bottle";
  return "a non-orientable surface of Euler characteristic " +
         std::to_string(link.euler_characteristic);
}

bool is_closed(const Triangulation& triangulation) {
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic != 2) return false;
  return true;
}

}  // namespace

void require_solvable(const Triangulation& triangulation) {
  if (!triangulation.is_connected())
    throw InvalidInput("the triangulation has " + std::to_string(triangulation.component_count()) +
                       " components; a metric is found for one connected manifold at a time: "
                       "take each by itself");
  if (is_closed(triangulation))
    throw Unsupported(
        "the link of every vertex is a sphere, so the manifold is closed; closed manifolds are not "
        "supported: a metric with geodesic boundary needs a link of genus 2 or more");
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
    const VertexLink& link = triangulation.link(v);
    if (!link.orientable)
      throw InvalidInput(place(triangulation, v) + " is " + surface_name(link) +
                         "; links must be orientable of genus 2 or more: take the orientable "
                         "double cover");
    if (link.euler_characteristic == 2)
      throw InvalidInput(place(triangulation, v) +
                         " is a sphere, so this is a finite vertex; simplify first to "
                         "remove it");
    if (link.euler_characteristic == 0)
      throw Unsupported(place(triangulation, v) +
                        " is a torus; cusps are not supported yet: every link must have genus "
                        "2 or more");
  }
}

}  // namespace tripus::topology
