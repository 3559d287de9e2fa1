#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "viewer/half_space.hpp"

namespace tripus::viewer {

/// How a primitive enters a CSG product.
enum class Operation { kIntersect, kSubtract };

/// A closed convex triangle mesh, counter-clockwise seen from outside.
struct ConvexMesh {
  std::vector<std::array<float, 3>> points;
  std::vector<std::array<std::uint32_t, 3>> triangles;
};

/// A half-space as a CSG primitive for a cell that lies in the unit ball of its local frame.
struct HalfSpacePrimitive {
  Operation operation = Operation::kIntersect;
  ConvexMesh mesh;
};

/// A cell's bounding mesh lies within this of the origin: here the primitives must be right.
inline constexpr double kBoundingReach = 1.07;
/// Radius of the cylinders that close primitives; as prisms of 12 sides they hold kBoundingReach.
inline constexpr double kPrimitiveReach = 1.12;
/// Meshes lie within this of the origin.
inline constexpr double kFarthestPoint = 2;

/// The primitive of a half-space. A ball, or a half-space bounded by a plane, is convex: it is
/// intersected. The outside of a ball is not: the ball is subtracted. Of a sphere that is larger
/// than the cell only the part near the cell is tessellated, and closed beyond kBoundingReach: so
/// planes are nothing special, a far centre costs no digits, and no mesh reaches farther than
/// kFarthestPoint, that is, behind the eye.
///   half_space  local frame, |grad f| = 1 on its wall, the wall meeting the ball of
///   kPrimitiveReach error       greatest distance of the mesh from the wall within kBoundingReach,
///   > 0
HalfSpacePrimitive half_space_primitive(const HalfSpace& half_space, double error);

/// A coarse ball that contains the unit ball and lies within kBoundingReach.
ConvexMesh bounding_mesh();

}  // namespace tripus::viewer
