#include "viewer/wall_discs.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/LU>
#include <fmt/format.h>

#include "base/error.hpp"
#include "base/stop.hpp"
#include "orthospectrum/boundary_discs.hpp"

namespace tripus::viewer {
namespace {

using orthospectrum::BoundarySurface;
using orthospectrum::Tile;
using ToTetrahedron = Eigen::Matrix<double, 4, 3>;

/// From the frame of a tile to that of its tetrahedron: the three corners say it.
ToTetrahedron placed(const BoundarySurface& surface, Tile tile,
                     const geometry::HyperboloidTetrahedron& tetrahedron) {
  orthospectrum::Matrix3 here;
  ToTetrahedron there;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto column = static_cast<Eigen::Index>(k);
    here.col(column) = surface.corner(tile, k);
    there.col(column) = geometry::corner(tetrahedron, static_cast<int>(tile.vertex),
                                         surface.corner_vertex(tile, k));
  }
  return there * here.inverse();
}

}  // namespace

WallDiscs make_wall_discs(const embedding::Embedding& embedding,
                          const topology::Triangulation& triangulation,
                          std::span<const double> edge_lengths,
                          const orthospectrum::Spectrum& spectrum) {
  const BoundarySurface surface(triangulation, edge_lengths);
  const auto discs = orthospectrum::discs_by_tile(surface, spectrum);
  WallDiscs result;
  result.scale = orthospectrum::scale_of(spectrum);
  result.length = spectrum.length;
  result.tiles.resize(discs.size());
  for (std::size_t n = 0; n < discs.size(); ++n) {
    const Tile tile{static_cast<std::uint32_t>(n / 4), static_cast<std::uint32_t>(n % 4)};
    if (discs[n].empty()) continue;
    const ToTetrahedron to = placed(surface, tile, embedding.tetrahedra[tile.tetrahedron]);
    for (const orthospectrum::TileDisc& disc : discs[n])
      result.tiles[n].push_back({to * disc.foot, 4 / std::expm1(2 * disc.length), disc.length});
    result.count += discs[n].size();
  }
  if (result.count > kMostDiscs) {
    throw InvalidInput(fmt::format("{} discs up to the length {:.4g}: a picture has at most {}",
                                   result.count, spectrum.length, kMostDiscs));
  }
  return result;
}

WallDiscs find_wall_discs(const embedding::Embedding& embedding,
                          const topology::Triangulation& triangulation,
                          std::span<const double> edge_lengths, std::optional<double> length,
                          const Context& context) {
  orthospectrum::SpectrumOptions options;
  if (length) {
    options.length = *length;
    if (!(*length > 0)) throw InvalidInput(fmt::format("the length {} is not positive", *length));
  } else {
    options.count = std::min(kMostUsualArcs, 4 * kArcsPerTile * triangulation.tetrahedron_count());
  }
  // Each arc has two discs, in more than one tile each.
  options.most_arcs = static_cast<double>(kMostDiscs) / 3;
  const orthospectrum::Spectrum spectrum =
      orthospectrum::orthospectrum(triangulation, edge_lengths, options, context);
  if (spectrum.end != orthospectrum::SpectrumEnd::kComplete) throw Stopped();
  return make_wall_discs(embedding, triangulation, edge_lengths, spectrum);
}

}  // namespace tripus::viewer
