#pragma once

#include "base/stop.hpp"
#include "topology/formats/formats.hpp"
#include "topology/simplify/ideal.hpp"

namespace tripus {

/// Makes a triangulation fit for what is done with it (topology::ideal_triangulation), with a note
/// of what was changed.
void make_ideal(topology::NamedGluings& loaded, topology::FiniteVertices finite_vertices,
                const Stop& stop = {});

}  // namespace tripus
