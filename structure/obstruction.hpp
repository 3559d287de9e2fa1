#pragma once

#include <string>

#include "topology/triangulation.hpp"

namespace tripus::structure {

/// Why the manifold is not hyperbolic, in a sentence; empty where the quick tests find nothing,
/// which says nothing. Exact, near linear in T:
///   - a closed bigon that decides (closed_bigon.hpp);
///   - the fundamental group is free: relators of the presentation vanish when generators that
///   occur
///     once in one of them are eliminated. Boundary of genus >= 2, and cusps, of a hyperbolic
///     manifold have groups that are embedded in it, and free groups have no such subgroups.
/// Only for connected orientable triangulations without finite vertices. Source: docs/verdicts.md.
std::string obstruction(const topology::Triangulation& triangulation);

}  // namespace tripus::structure
