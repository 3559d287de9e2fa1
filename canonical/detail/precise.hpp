#pragma once

#include <array>
#include <span>
#include <vector>

#include "topology/triangulation.hpp"

namespace tripus::canonical::detail {

/// A face of a tetrahedron.
struct FacePlace {
  std::size_t tetrahedron;
  int face;
};

/// Tilt sums across the given faces, computed in 50 decimal digits from lengths [E] that are
/// improved to as many first. Returned in double precision, so that a true 0 appears as some 1e-48.
/// Throws InternalError if the lengths are too far from those of the metric to be improved.
std::vector<double> precise_tilt_sums(const topology::Triangulation& triangulation,
                                      std::span<const double> lengths,
                                      std::span<const FacePlace> faces);

}  // namespace tripus::canonical::detail
