#pragma once

#include <vector>

#include "embedding/embedding.hpp"

namespace tripus::embedding {

/// The fundamental domain: each tetrahedron once, developed along the breadth-first spanning tree
/// of the dual graph from tetrahedron 0 (topology::spanning_forest). Returns [T] the isometries
/// from the frames of the tetrahedra to that of tetrahedron 0. Source: docs/theory.md (71).
std::vector<Matrix4> fundamental_domain(const Embedding& embedding,
                                        const topology::Gluings& gluings);

}  // namespace tripus::embedding
