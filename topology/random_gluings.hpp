#pragma once

#include <cstddef>
#include <random>

#include "topology/enumerate.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A random connected orientable triangulation whose links are as asked for: all ways to glue the
/// 4 T faces of labelled oriented tetrahedra in pairs are equally likely, those that are not wanted
/// are drawn again. So a triangulation comes with a probability proportional to 1 / (its number of
/// automorphisms), as `enumerate` counts them. `draws`, if there, is increased by the number of
/// draws. Nearly every draw hits for kGeodesic and three or more tetrahedra; for the other choices
/// hits are rare. Throws InvalidInput for fewer than 2 tetrahedra, or 3 with kMixed, where there is
/// none to be drawn, and after 10^8 draws without a hit.
Gluings random_gluings(std::size_t tetrahedra, LinkChoice links, std::mt19937_64& random,
                       std::size_t* draws = nullptr);

}  // namespace tripus::topology
