#pragma once

#include <optional>
#include <span>
#include <string>

#include "topology/triangulation.hpp"
#include "viewer/camera.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// Tells the cells of a scene their classes, and the scene the lengths of its edges.
///   edge_lengths  of the edge classes; may be empty
void add_classes(Scene& scene, const topology::Triangulation& triangulation,
                 std::span<const double> edge_lengths);

/// What a wall of a cell is, in a line for people: tetrahedron, face or truncation, and of a face
/// its edges with classes, lengths and dihedral angles in degrees. No angle is given for a wall
/// beyond 7, a cut.
std::string describe(const Scene& scene, std::size_t cell, std::size_t wall);

/// A wall, or beyond 7 a cut, of a cell of a scene.
struct SeenWall {
  std::size_t cell = 0;
  std::size_t wall = 0;
};

/// What a pixel shows; nothing where no cell is, or outside the picture.
///   identities  a picture drawn by Pixels::kIdentities
std::optional<SeenWall> seen_at(const Image& identities, int x, int y);

/// A word beside its place in a picture, pixels from the upper left corner.
struct SceneLabel {
  float x = 0, y = 0;
  std::string text;
};

/// Names of tetrahedra where they cover much of a picture, in the middle of what is seen of them,
/// and of edge classes, "e" and their number, at the middles of edges that are seen.
///   identities  the picture, drawn by Pixels::kIdentities with one sample
std::vector<SceneLabel> labels_of(const Scene& scene, const PictureOptions& options,
                                  const Image& identities);

}  // namespace tripus::viewer
