#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "topology/gluings.hpp"

namespace tripus::testing {

/// A solid of unit cubes out of an n x n x n grid, each cut into six tetrahedra around a diagonal,
/// with open faces where it ends. `is_solid(x, y, z)` tells which cubes belong to it.
template <class IsSolid>
topology::Gluings cube_mesh(int n, IsSolid&& is_solid) {
  constexpr std::array<std::array<std::size_t, 3>, 6> kOrders{
      {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}}};
  const auto point = [&](const std::array<int, 3>& p) {
    return (p[0] * (n + 1) + p[1]) * (n + 1) + p[2];
  };
  std::vector<std::array<int, 4>> tetrahedra;
  for (int x = 0; x < n; ++x)
    for (int y = 0; y < n; ++y)
      for (int z = 0; z < n; ++z) {
        if (!is_solid(x, y, z)) continue;
        for (const auto& order : kOrders) {
          std::array<int, 3> corner{x, y, z};
          auto& points = tetrahedra.emplace_back();
          points[0] = point(corner);
          for (std::size_t k = 0; k < 3; ++k) {
            ++corner[order[k]];
            points[k + 1] = point(corner);
          }
        }
      }

  struct Face {
    std::array<int, 3> points;
    std::uint32_t t;
    int f;
  };
  std::vector<Face> faces;
  for (std::uint32_t t = 0; t < tetrahedra.size(); ++t)
    for (int f = 0; f < 4; ++f) {
      Face face{{}, t, f};
      std::size_t k = 0;
      for (int v = 0; v < 4; ++v)
        if (v != f) face.points[k++] = tetrahedra[t][static_cast<std::size_t>(v)];
      std::ranges::sort(face.points);
      faces.push_back(face);
    }
  std::ranges::stable_sort(faces, {}, &Face::points);
  topology::Gluings gluings(tetrahedra.size());
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    const Face& one = faces[i];
    const Face& two = faces[i + 1];
    if (one.points != two.points) continue;
    std::array<int, 4> images{};
    for (int v = 0; v < 4; ++v)
      images[static_cast<std::size_t>(v)] =
          v == one.f
              ? two.f
              : static_cast<int>(std::ranges::find(tetrahedra[two.t],
                                                   tetrahedra[one.t][static_cast<std::size_t>(v)]) -
                                 tetrahedra[two.t].begin());
    gluings.glue(one.t, one.f, two.t,
                 topology::Perm4::from_images(images[0], images[1], images[2], images[3]));
  }
  return gluings;
}

}  // namespace tripus::testing
