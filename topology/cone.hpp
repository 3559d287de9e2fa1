#pragma once

#include "topology/gluings.hpp"

namespace tripus::topology {

/// Closes up a triangulation with boundary: every component of the surface of open faces is coned
/// off by a new vertex, whose link is that surface. A sphere is thereby filled in with a ball; a
/// surface of genus >= 2 becomes an ideal vertex that stands for a boundary component. The given
/// tetrahedra keep their numbers and labels, one follows for each open face, in their order;
/// oriented tables stay oriented. Without open faces the result is the input. O(T).
/// Throws InvalidInput, naming tetrahedron and face or vertex, if the gluings are not consistent,
/// if the surface is pinched (it meets itself at a vertex), if the link of a vertex on it is
/// no disc for another reason, or if there would be more than kMaxTetrahedra tetrahedra.
Gluings cone_boundary(const Gluings& gluings);

}  // namespace tripus::topology
