#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "topology/cone_angle.hpp"
#include "topology/triangulation.hpp"

namespace tripus::topology {

/// What a vertex class is in hyperbolic space: the sign of the orbifold Euler characteristic of its
/// link, negative, zero or positive. docs/theory.md (76).
enum class VertexKind : std::uint8_t { kHyperideal, kIdeal, kFinite };
/// "geodesic", "cusp" or "finite".
std::string_view to_string(VertexKind kind);

/// A vertex link with the cone points that labels put on it.
struct OrbifoldLink {
  VertexKind kind = VertexKind::kHyperideal;
  /// chi(link) - sum over edge ends here of (1 - k_e / 2 pi); exactly 0 if ideal.
  double euler_characteristic = 0;
  std::size_t cone_points = 0;  ///< edge ends here whose cone angle is not 2 pi
};

/// The links [V] with cone angles [E] (empty: 2 pi everywhere). The sign is exact where the angles
/// are rational multiples of pi; else within 1e-12 of 0 counts as 0.
/// Throws InvalidInput as `completed` does.
std::vector<OrbifoldLink> orbifold_links(const Triangulation& triangulation,
                                         std::span<const ConeAngle> cone_angles = {});

/// "a torus", "a Klein bottle", "a surface of genus 2", "a non-orientable surface of Euler
/// characteristic -1", ...
std::string surface_name(const VertexLink& link);

/// "the link of vertex class 2 (vertex 0 of tetrahedron 1)", for messages.
std::string link_place(const Triangulation& triangulation, std::size_t vertex);

}  // namespace tripus::topology
