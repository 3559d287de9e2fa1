#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "embedding/embedding.hpp"
#include "topology/triangulation.hpp"
#include "viewer/wall_discs.hpp"

namespace tripus::viewer {

/// A manifold to stand in: its tetrahedra, each in its own frame, and what lies behind their faces.
struct InsideManifold {
  std::vector<embedding::HyperboloidTetrahedron> tetrahedra;  ///< [T]
  std::vector<std::array<std::uint32_t, 4>> neighbour;        ///< [T x 4]
  std::vector<std::array<std::uint8_t, 4>> entry;             ///< its face, glued here
  std::vector<std::array<geometry::Matrix4, 4>> crossing;     ///< to its coordinates
  std::vector<std::array<std::uint32_t, 6>> edge_class;       ///< [T x 6]
  std::vector<std::array<std::uint32_t, 4>> vertex_class;     ///< [T x 4]
  std::vector<std::uint8_t> singular_edges;                   ///< [T]
  std::vector<double> edge_lengths;                           ///< [E]; may be empty
  std::shared_ptr<const WallDiscs> discs;                     ///< null: none

  /// What web/inside.frag.glsl has to know of, its kKinds: 0 hyperideal vertices alone; 1 vertices
  /// of other kinds; 2 parabolic edges.
  int kinds() const;
};

InsideManifold inside_manifold(const embedding::Embedding& embedding,
                               const topology::Triangulation& triangulation,
                               std::vector<double> edge_lengths = {},
                               std::shared_ptr<const WallDiscs> discs = nullptr);

/// Texels of four numbers in the record of a tetrahedron, and records in a row of a texture that is
/// 2048 texels wide.
inline constexpr std::size_t kInsideTexels = 37, kInsidePerRow = 2048 / kInsideTexels;

/// The records of all tetrahedra, as web/inside.frag.glsl reads them.
///   first_disc  [4 T] texel where the discs of a truncation begin; empty: there are none
std::vector<float> inside_records(const InsideManifold& manifold,
                                  const std::vector<float>& first_disc);

/// What a pixel shows, in a line for people; empty for nothing.
///   kind         0 nothing, 1 a wall, 2 an edge
///   number       of the vertex or edge of the tetrahedron; of the wall of parabolic edge e 4 + e
std::string describe_inside(const InsideManifold& manifold, int kind, std::size_t tetrahedron,
                            std::size_t number);

}  // namespace tripus::viewer
