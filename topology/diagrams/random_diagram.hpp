#pragma once

#include <cstddef>
#include <cstdint>

#include "topology/diagrams/diagram.hpp"

namespace tripus::topology {

/// A random connected diagram: a plane map with `nodes` nodes of degree 4, each as likely as any
/// other (rooted), of which the first `vertices` are vertices of a graph and the others crossings
/// with a random strand above. Links of several components, loops and nugatory crossings occur as
/// they do. The same for the same seed on every platform. O(nodes).
///
/// A binary tree, each node with a bud at a random place besides its two children, closes up to a
/// map: every bud is joined to the next free leaf on the way around the tree.
/// Source: G. Schaeffer, *Bijective census and random generation of Eulerian planar maps* (1997).
/// Throws InvalidInput for no nodes, or more vertices than nodes.
Diagram random_diagram(std::size_t nodes, std::uint64_t seed, std::size_t vertices = 0);

}  // namespace tripus::topology
