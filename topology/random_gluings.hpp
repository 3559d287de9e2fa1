#pragma once

#include <cstddef>
#include <random>

#include "topology/enumerate.hpp"
#include "topology/gluings.hpp"

namespace tripus::topology {

/// A random connected triangulation such as asked for: all ways to glue the 4 T faces of labelled
/// tetrahedra in pairs (oriented ones, if it is to be orientable) are equally likely, those that
/// are not wanted are drawn again. So a triangulation comes with a probability proportional to 1 /
/// (its number of automorphisms), as `enumerate` counts them. `draws`, if there, is increased by
/// the number of draws. Nearly every draw of an orientable one hits for kGeodesic and three or more
/// tetrahedra; for the other choices hits are rare. Throws InvalidInput for fewer tetrahedra than
/// any has (3 with kMixed, else 2; one with kCusped if it need not be orientable), and after 10^8
/// draws without a hit.
Gluings random_gluings(std::size_t tetrahedra, const EnumerationChoice& choice,
                       std::mt19937_64& random, std::size_t* draws = nullptr);

}  // namespace tripus::topology
