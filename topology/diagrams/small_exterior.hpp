#pragma once

#include "topology/diagrams/read_diagram.hpp"
#include "topology/formats/formats.hpp"
#include "topology/simplify/simplify.hpp"

namespace tripus::topology {

/// A small triangulation of the exterior of a diagram's graph, oriented as space is, with a note of
/// how it came about. Strands with labels are edges with these cone angles, and are not drilled;
/// with the angle 2 pi a strand is filled in, as by a 2-handle along its meridian. Throws what
/// `exterior` throws.
NamedGluings small_exterior(const NamedDiagram& diagram, const SimplifyOptions& options = {});

}  // namespace tripus::topology
