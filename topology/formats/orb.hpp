#pragma once

#include <string>
#include <string_view>

#include "topology/formats/formats.hpp"

namespace tripus::topology {

/// Reads a file of Orb (or Casson), which begins with "% orb": the gluings and the cone orders of
/// its edges. What follows the rows of edges (lengths, angles, curves, a diagram) is not read.
/// Throws InvalidInput, naming the line and what was expected there.
NamedGluings read_orb(std::string_view text);

/// Writes the same: a row for each edge class, with its cone order and its corners in cyclic order,
/// and no solution. Colours number the singular edges from 1.
/// The tetrahedra are relabelled to agree in orientation, which the format needs.
/// Throws InvalidInput where the triangulation is not orientable, or a cone angle not known to be a
/// rational multiple of pi.
std::string write_orb(const NamedGluings& triangulation);

}  // namespace tripus::topology
