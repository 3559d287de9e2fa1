#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "topology/covers/transitive_actions.hpp"
#include "topology/homology.hpp"

namespace tripus::topology {

/// How many connected covers have which first homology, as to_string writes it.
using CoverHomology = std::map<std::string, std::size_t>;

/// First homology of all connected covers of a degree up to isomorphism of covers: the abelian
/// invariants of the subgroups of that index up to conjugation. It depends on the manifold only,
/// and often tells apart what H1 and the boundary do not.
/// Throws InvalidInput as for_each_cover.
CoverHomology cover_homology(const Triangulation& triangulation, std::size_t degree);

/// First homology of the cover of an action, from the presentation alone: its generators and
/// relators on every sheet, less a spanning tree (Reidemeister and Schreier).
AbelianGroup first_homology(const Presentation& presentation, const TransitiveAction& action);

}  // namespace tripus::topology
