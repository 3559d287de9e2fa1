#pragma once

#include <cstddef>

#include "base/stop.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A triangulation made fit for a metric with geodesic boundary.
struct IdealTriangulation {
  Gluings gluings;
  std::size_t given = 0;            ///< T of the input
  std::size_t coned_faces = 0;      ///< open faces that were coned off
  std::size_t finite_vertices = 0;  ///< vertices with sphere links that were removed
  bool is_changed() const { return coned_faces > 0 || finite_vertices > 0; }
};

enum class FiniteVertices {
  kKeep,
  kRemove,  ///< where the component has a vertex of another kind; closed ones are left alone
};

/// Cones off the boundary, each component of it to a vertex (a sphere is filled in: cone_boundary),
/// and removes finite vertices by `simplify`. The orientation is kept; unchanged if there is
/// nothing to do. When stopped, some finite vertices may be left. Throws InvalidInput as
/// cone_boundary and the constructor of Triangulation.
IdealTriangulation ideal_triangulation(const Gluings& gluings, FiniteVertices finite_vertices,
                                       const Stop& stop = {});

}  // namespace tripus::topology
