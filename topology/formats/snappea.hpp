#pragma once

#include <string>
#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads SnapPea's triangulation text ("% Triangulation"), as SnapPea, SnapPy, Regina and Orb
/// write it. Of each tetrahedron only the line of neighbours and the line of permutations after it
/// are read; cusps, peripheral curves and shapes are skipped. `//` starts a comment.
/// Throws InvalidInput naming the line, tetrahedron and face.
NamedGluings read_snappea(std::string_view text);

/// The file Regina would write: no cusps listed, structures left for the reader to compute.
/// Throws InvalidInput if a face is open: the format cannot say so.
std::string write_snappea(const NamedGluings& triangulation);

}  // namespace tripus::topology
