#pragma once

#include <array>
#include <span>
#include <vector>

#include "canonical/detail/tetrahedron_tilts.hpp"
#include "canonical/tilts.hpp"
#include "topology/triangulation.hpp"

namespace tripus::canonical::detail {

/// A face of a tetrahedron.
struct FacePlace {
  std::size_t tetrahedron;
  int face;
};

/// The kinds of the vertices of every tetrahedron [T].
/// Throws InvalidInput if one is finite.
std::vector<Diagonal> diagonals(const topology::Triangulation& triangulation,
                                std::span<const topology::ConeAngle> cone_angles);

/// Tilt sums across the given faces, computed in 50 decimal digits from lengths [E] that are
/// improved to as many first, from horospheres of one area. Returned in double precision, so that a
/// true 0 appears as some 1e-48.
/// Throws InternalError if the lengths are too far from those of the metric to be improved.
std::vector<Tilt> precise_tilt_sums(const topology::Triangulation& triangulation,
                                    std::span<const double> lengths,
                                    std::span<const topology::ConeAngle> cone_angles,
                                    std::span<const Diagonal> diagonals,
                                    std::span<const FacePlace> faces);

}  // namespace tripus::canonical::detail
