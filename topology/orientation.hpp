#pragma once

#include <optional>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::topology {

// The orientation of a table is the one in which the labels 0123 of tetrahedron 0 are positive (of
// the first tetrahedron of each component). A table is *oriented* if the labels of all tetrahedra
// are: every gluing permutation is then odd, and moves keep the orientation.

/// The same triangulation with labels that make every gluing permutation odd; those of the first
/// tetrahedron of each component stay. Unchanged if it is not orientable. Open faces are allowed.
Gluings oriented(const Gluings& gluings);

/// Whether such labels exist.
bool is_orientable(const Gluings& gluings);

/// [T] for which tetrahedra `oriented` changes the labels; nothing if it is not orientable.
std::optional<std::vector<char>> disagreeing_labels(const Gluings& gluings);

/// The same triangulation with the labels 2 and 3 of every tetrahedron exchanged, which reverses
/// the orientation; an oriented table stays oriented.
Gluings mirrored(const Gluings& gluings);

}  // namespace tripus::topology
