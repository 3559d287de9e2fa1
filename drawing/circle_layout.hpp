#pragma once

#include <array>
#include <complex>
#include <cstddef>
#include <vector>

#include "topology/diagrams/diagram.hpp"

namespace tripus::drawing {

using Point = std::complex<double>;

struct Disc {
  Point centre;
  double radius = 0;
};

/// A diagram as discs in the plane that touch: one for each node, and along each arc one or (for a
/// loop) two, each touching the next. No two of all these discs overlap, so curves that stay in
/// them meet only in the discs of crossings: the picture is planar by construction.
struct CircleLayout {
  std::vector<Disc> nodes;              ///< [N]
  std::vector<std::vector<Disc>> arcs;  ///< [D] from the dart's node on; those of its mate reversed
};

/// Packs circles: between the discs of nodes and arcs each region holds one or more of its own, and
/// all are tangent as a triangulated disc says (Koebe, Andreev, Thurston). Boundary: the region
/// with most corners; its discs get one radius. Pieces that touch nowhere lie side by side. Radii
/// to 1e-12 by Collins' and Stephenson's iteration; cost about quadratic in the number of arcs.
/// Throws InvalidInput for more than kMostArcsDrawn arcs.
CircleLayout circle_layout(const topology::Diagram& diagram);
inline constexpr std::size_t kMostArcsDrawn = 2000;

}  // namespace tripus::drawing
