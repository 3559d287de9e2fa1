#include "structure/obstruction.hpp"

#include "structure/closed_bigon.hpp"
#include "topology/covers/presentation.hpp"

namespace tripus::structure {
namespace {

bool is_in_domain(const topology::Triangulation& triangulation) {
  if (!triangulation.is_connected() || !triangulation.is_orientable()) return false;
  for (std::size_t v = 0; v < triangulation.vertex_count(); ++v)
    if (triangulation.link(v).euler_characteristic > 0) return false;
  return true;
}

}  // namespace

std::string obstruction(const topology::Triangulation& triangulation) {
  if (!is_in_domain(triangulation)) return {};
  if (const auto bigon = closed_bigon(triangulation); bigon && bigon->decides())
    return message(*bigon);
  const auto group = topology::reduced(topology::fundamental_group(triangulation).presentation);
  if (group.presentation.relators.empty())
    return "The manifold is not hyperbolic: its fundamental group is free, unlike that of a "
           "manifold with such a boundary.";
  return {};
}

}  // namespace tripus::structure
