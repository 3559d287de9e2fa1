#pragma once

#include <array>
#include <cstdint>

#include "meshing/tube/detail/vector3.hpp"

namespace tripus::meshing::tube {

/// A triangle or tetrahedron with the names of its corners.
template <std::size_t N>
struct Simplex {
  std::array<std::uint32_t, N> names;
  std::array<Point, N> points;

  Bounds bounds() const {
    Bounds result;
    for (const Point& p : points) result.add(p);
    return result;
  }
};

/// Whether a tetrahedron and a triangle meet in nothing but the corners, or the edge, that they
/// have in common by name. May say no where they only come close (never says yes wrongly, but for
/// rounding far below tolerance::kSweepClearance).
bool meet_in_common_face_only(const Simplex<4>& tetrahedron, const Simplex<3>& triangle);

}  // namespace tripus::meshing::tube
