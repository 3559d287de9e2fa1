#pragma once

#include <vector>

#include "embedding/universal_cover.hpp"
#include "geometry/moebius.hpp"

namespace tripus::embedding {

/// Where each tetrahedron comes to lie when they are developed, one beside the other, along the
/// breadth-first spanning tree of the dual graph from tetrahedron 0 (topology::spanning_forest).
/// Returns [T] the isometries from the frames of the tetrahedra to that of tetrahedron 0.
/// They are products in SL(2,C), so their relative error grows with the depth of the tree only, and
/// which of them reverse orientation goes by the gluings alone.
/// Source: docs/theory.md (71).
std::vector<geometry::MoebiusMap> developing_map(const Embedding& embedding,
                                                 const topology::Gluings& gluings);

/// The same as cells, parents before children: a fundamental domain, each tetrahedron once.
std::vector<Cell> fundamental_domain(const Embedding& embedding, const topology::Gluings& gluings);

}  // namespace tripus::embedding
