#pragma once

#include "topology/gluings.hpp"

namespace tripus::topology {

/// Whether neighbouring tetrahedra have numbers so far apart that going from one to the next mostly
/// misses the caches. Never for small tables.
bool is_scattered(const Gluings& gluings);

/// The same closed-up table with the tetrahedra numbered breadth first, labels kept. O(T).
Gluings breadth_first(const Gluings& gluings);

}  // namespace tripus::topology
