#pragma once

#include <vector>

#include "orthospectrum/boundary_surface.hpp"
#include "orthospectrum/length_colours.hpp"

namespace tripus::orthospectrum {

/// A disc of the boundary, as one tile that it meets has it: the normals around the foot of an arc
/// that run into the same plane as the arc.
struct TileDisc {
  Vector3 foot;       ///< of the arc, in the frame of the tile; it may lie beyond the tile
  double length = 0;  ///< of the arc; disc_radius(length) is the radius
};

/// The discs that each tile meets, largest first: both of each arc, in every tile, as often as they
/// meet it. No two of a tile overlap. O(discs).
///   spectrum  with its arcs, of the manifold of the surface
/// Returns [4 T]; nothing for ideal vertices.
std::vector<std::vector<TileDisc>> discs_by_tile(const BoundarySurface& surface,
                                                 const Spectrum& spectrum);

/// What the colours of the discs of a spectrum go by.
LengthScale scale_of(const Spectrum& spectrum);

}  // namespace tripus::orthospectrum
