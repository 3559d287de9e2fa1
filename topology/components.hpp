#pragma once

#include <vector>

#include "topology/triangulation.hpp"

namespace tripus::topology {

/// The connected components of a gluing table (open faces are allowed), in the order of their
/// first tetrahedra; within each, tetrahedra keep their order and vertices their labels.
std::vector<Gluings> components(const Gluings& gluings);

/// The same for triangulations.
std::vector<Triangulation> components(const Triangulation& triangulation);

}  // namespace tripus::topology
