#pragma once

#include <array>
#include <cstddef>

#include "embedding/embedding.hpp"
#include "viewer/picture.hpp"

namespace tripus::viewer {

/// What a geodesic meets first: the geodesic boundary or nothing within reach.
struct Sight {
  bool wall = false;
  std::size_t tetrahedron = 0;  ///< where it ended
  std::size_t vertex = 0;       ///< of the wall met; of parabolic edge e 4 + e
  double distance = 0;          ///< along the geodesic
  double facing = 0;            ///< cosine at which it meets the wall
  double side = 0;              ///< distance of that point from the sides of its wall
};

/// Follows the geodesic from a point of a tetrahedron through the glued faces.
///   point      on the hyperboloid, in the frame of the tetrahedron, inside it
///   direction  unit, tangent at the point
/// Gives up after `most_crossings` faces. Double precision throughout.
Sight look(const embedding::Embedding& embedding, const topology::Triangulation& triangulation,
           std::size_t tetrahedron, const geometry::Vector4& point,
           const geometry::Vector4& direction, int most_crossings = 60);

/// A small picture of the manifold from the centre of tetrahedron 0, as the inside view of its page
/// shows it, four samples a pixel. It needs no graphics card and no browser: thousands in a gallery
/// cost milliseconds each.
Image inside_picture(const embedding::Embedding& embedding,
                     const topology::Triangulation& triangulation, int width, int height);

}  // namespace tripus::viewer
