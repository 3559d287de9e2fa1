#pragma once

#include <string>
#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads SnapPea's triangulation text ("% Triangulation"), as SnapPea, SnapPy, Regina and Orb
/// write it, also in free form, where lines mean nothing. Of each tetrahedron only the neighbours
/// and the permutations are read; peripheral curves and shapes are skipped. `//` starts a comment.
/// Throws InvalidInput naming the line, tetrahedron and face; Unsupported for Dehn fillings.
NamedGluings read_snappea(std::string_view text);

/// The file Regina would write: no cusps listed, structures left for the reader to compute.
/// Throws InvalidInput if a face is open: the format cannot say so.
std::string write_snappea(const NamedGluings& triangulation);

}  // namespace tripus::topology
