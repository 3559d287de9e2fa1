#pragma once

#include <cstdint>

#include "viewer/inside/inside_manifold.hpp"

namespace tripus::viewer {

/// Where one stands at first, in tetrahedron 0.
enum class StandingPlace : std::uint8_t {
  kCentre,
  kWall,  ///< near the wall of vertex 0
  kEdge,  ///< near edge 01
};

/// One who stands in a manifold: in a tetrahedron, by a frame in its coordinates.
struct Walker {
  std::uint32_t tetrahedron = 0;
  /// Columns: right, up, forward, position; an isometry that need not keep orientation.
  geometry::Matrix4 frame = geometry::Matrix4::Identity();

  geometry::Vector4 position() const { return frame.col(3); }

  /// Turns to the right, upwards, and clockwise, radians.
  void turn(double right, double up, double roll = 0);

  /// Walks a distance in a direction (right, up, forward), through faces, but not through the wall:
  /// what is left of a step that meets the wall goes along it. Returns true at a wall.
  bool walk(const InsideManifold& manifold, const geometry::Vector3& direction, double distance);
};

/// How near a wall one can come.
inline constexpr double kWallClearance = 0.06;

/// One who has just come.
Walker standing_at(const InsideManifold& manifold, StandingPlace place);

/// Whether a walker stands in the tetrahedron, in front of its walls, in a frame that is one.
bool stands_inside(const InsideManifold& manifold, const Walker& walker);

}  // namespace tripus::viewer
