#pragma once

#include <optional>
#include <span>
#include <vector>

#include "embedding/embedding.hpp"
#include "orthospectrum/length_colours.hpp"
#include "orthospectrum/spectrum.hpp"
#include "viewer/half_space.hpp"

namespace tripus::viewer {

/// A disc on a truncation, in the coordinates of its tetrahedron. With the point x of the
/// hyperboloid on the truncation, x lies in it if <x - centre, x - centre> < extent: the left is
/// 4 sinh^2 of half their distance, and keeps its digits in single precision too.
struct WallDisc {
  Vector4 centre;
  double extent = 0;  ///< 4 sinh^2 of half the radius
  double length = 0;  ///< of its arc
};

/// The discs of a spectrum on the truncations that they meet: Calegari's leopard spots. Source:
/// docs/orthospectrum.md.
struct WallDiscs {
  std::vector<std::vector<WallDisc>> tiles;  ///< [4 T] of vertex v of tetrahedron t: 4 t + v
  orthospectrum::LengthScale scale;          ///< of the colours
  double length = 0;                         ///< all arcs up to it have their discs
  std::size_t count = 0;                     ///< in all tiles
};

/// Discs in all tiles that a picture may have.
inline constexpr std::size_t kMostDiscs = 1'000'000;
/// Arcs whose discs are drawn where no length is given: so many for each tile, and at most so many.
inline constexpr std::size_t kArcsPerTile = 12, kMostUsualArcs = 6000;

/// What is seen between the discs, sRGB.
inline constexpr orthospectrum::LengthColour kBareWall{240, 237, 227};

/// Finds the arcs and makes their discs.
///   length  of the longest; nothing: what the number of tiles says
/// Throws as orthospectrum::orthospectrum does, InvalidInput where there would be more than
/// kMostDiscs, and Stopped.
WallDiscs find_wall_discs(const embedding::Embedding& embedding,
                          const topology::Triangulation& triangulation,
                          std::span<const double> edge_lengths, std::optional<double> length,
                          const Context& context = {});

///   embedding, edge_lengths, spectrum  of the same metric; the spectrum has its arcs
/// Throws InvalidInput where there would be more than kMostDiscs.
WallDiscs make_wall_discs(const embedding::Embedding& embedding,
                          const topology::Triangulation& triangulation,
                          std::span<const double> edge_lengths,
                          const orthospectrum::Spectrum& spectrum);

}  // namespace tripus::viewer
