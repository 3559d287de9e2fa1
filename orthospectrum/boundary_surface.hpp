#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include <Eigen/Core>

#include "orthospectrum/spectrum.hpp"

namespace tripus::orthospectrum {

/// Isometries of the hyperbolic plane x^2 + y^2 - z^2 = -1, z > 0.
using Matrix3 = Eigen::Matrix3d;
using Vector3 = Eigen::Vector3d;

/// The end of an arc in the frame of its tile.
Vector3 point_of(const ArcEnd& end);

/// A copy of a tile in the universal cover of its boundary component.
struct DevelopedTile {
  Tile tile;
  Matrix3 isometry;   ///< from the frame of the tile to that of the picture
  bool first = true;  ///< whether it is the first copy: these are a fundamental domain
};

/// The boundary as a surface that truncation triangles tile.
class BoundarySurface {
 public:
  /// Throws InvalidInput as `orthospectrum` does.
  BoundarySurface(const topology::Triangulation& triangulation,
                  std::span<const double> edge_lengths);

  /// Ideal vertices have no tile.
  bool has(Tile tile) const { return is_tile_[index(tile)]; }
  /// 4 T, those of ideal vertices among them, and where one is among them.
  std::size_t tile_count() const { return is_tile_.size(); }
  static std::size_t index(Tile tile) { return 4 * std::size_t{tile.tetrahedron} + tile.vertex; }
  /// Corner k of a tile, k = 0, 1, 2, in its own frame, where edge `corner_vertex(tile, k)` ends.
  Vector3 corner(Tile tile, std::size_t k) const { return corners_[index(tile)].col(column(k)); }
  /// The other end of the edge of the tetrahedron at this corner.
  int corner_vertex(Tile tile, std::size_t k) const { return vertices_[index(tile)][k]; }

  /// Develops the component of a tile around it, nearest tiles first, until no tile with its middle
  /// within the distance `radius` is left and each tile of the component has been there, or
  /// `most_tiles` are there (then some copies are left out, but no tile).
  std::vector<DevelopedTile> develop(Tile from, double radius, std::size_t most_tiles) const;

  /// The copies of tiles that the disc of this radius around a point of `from` meets, in the frame
  /// of `from`, which comes first. O(copies log copies).
  std::vector<DevelopedTile> meeting(Tile from, const Vector3& centre, double radius) const;

 private:
  struct Side {
    Tile across;
    Matrix3 isometry;  // from the frame of `across` to that of the tile
  };
  static Eigen::Index column(std::size_t k) { return static_cast<Eigen::Index>(k); }

  std::vector<bool> is_tile_;                          // [4 T], as all that follows
  std::vector<Matrix3> corners_;                       // [tiles] columns: the corners
  std::vector<std::array<std::uint8_t, 3>> vertices_;  // [tiles]
  std::vector<std::array<Side, 3>> sides_;             // [tiles] side k is opposite to corner k
};

}  // namespace tripus::orthospectrum
