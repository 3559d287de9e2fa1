#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>
#include <random>

#include "meshing/surface_mesh.hpp"

/// Surfaces with known shape, oriented outwards, for the tests of meshing.
namespace tripus::testing {

using meshing::Point;
using meshing::SurfaceMesh;
using meshing::Triangle;

/// The box [low, high]^3 with n x n squares a side, each cut in two: 12 n^2 triangles.
inline SurfaceMesh box_surface(double low = 0, double high = 1, std::uint32_t n = 1) {
  SurfaceMesh mesh;
  std::vector<std::uint32_t> number((n + 1) * (n + 1) * (n + 1), UINT32_MAX);
  const auto point = [&](std::array<std::uint32_t, 3> at) {
    std::uint32_t& known = number[(at[0] * (n + 1) + at[1]) * (n + 1) + at[2]];
    if (known == UINT32_MAX) {
      known = static_cast<std::uint32_t>(mesh.points.size());
      Point p;
      for (std::size_t k = 0; k < 3; ++k) p[k] = low + (high - low) * at[k] / n;
      mesh.points.push_back(p);
    }
    return known;
  };
  for (std::size_t axis = 0; axis < 3; ++axis)
    for (const bool upper : {false, true})
      for (std::uint32_t i = 0; i < n; ++i)
        for (std::uint32_t j = 0; j < n; ++j) {
          const auto corner = [&](std::uint32_t di, std::uint32_t dj) {
            std::array<std::uint32_t, 3> at{};
            at[axis] = upper ? n : 0;
            at[(axis + 1) % 3] = i + di;
            at[(axis + 2) % 3] = j + dj;
            return point(at);
          };
          const std::uint32_t a = corner(0, 0), b = corner(1, 0), c = corner(1, 1),
                              d = corner(0, 1);
          mesh.triangles.push_back(upper ? Triangle{a, b, c} : Triangle{a, c, b});
          mesh.triangles.push_back(upper ? Triangle{a, c, d} : Triangle{a, d, c});
        }
  return mesh;
}

/// A torus around the z axis: radii `ring` and `pipe`, 2 n m triangles.
inline SurfaceMesh torus_surface(double ring, double pipe, std::uint32_t n, std::uint32_t m,
                                 Point centre = {0, 0, 0}) {
  SurfaceMesh mesh;
  constexpr double kTurn = 2 * std::numbers::pi;
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      const double u = kTurn * i / n, v = kTurn * j / m, r = ring + pipe * std::cos(v);
      mesh.points.push_back({centre[0] + r * std::cos(u), centre[1] + r * std::sin(u),
                             centre[2] + pipe * std::sin(v)});
    }
  const auto at = [&](std::uint32_t i, std::uint32_t j) { return i % n * m + j % m; };
  for (std::uint32_t i = 0; i < n; ++i)
    for (std::uint32_t j = 0; j < m; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  return mesh;
}

/// Both surfaces in one mesh.
inline SurfaceMesh joined(SurfaceMesh left, const SurfaceMesh& right) {
  const auto shift = static_cast<std::uint32_t>(left.points.size());
  left.points.insert(left.points.end(), right.points.begin(), right.points.end());
  for (const Triangle& t : right.triangles)
    left.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
  return left;
}

}  // namespace tripus::testing
