#pragma once

#include <cstddef>
#include <vector>

#include "base/stop.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A few small triangulations of the same manifold, smallest first, no two isomorphic: what
/// `simplify` finds with the seeds 0, 1, ... and the effort. To begin with where the manifold is
/// asked about and not the triangulation. Each is labelled as its signature decodes; of an
/// orientable connected manifold the orientation is kept, and the table oriented. Empty if stopped.
/// Throws what `simplify` throws.
std::vector<Gluings> small_triangulations(const Gluings& closed, std::size_t seeds,
                                          const Stop& stop = {}, double effort = 1.0);

}  // namespace tripus::topology
