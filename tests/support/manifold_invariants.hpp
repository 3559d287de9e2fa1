#pragma once

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "topology/homology.hpp"
#include "topology/triangulation.hpp"

namespace tripus::testing {

/// What no move may change (law M1 of topology/README.md); finite vertices are counted apart.
/// Further invariants of the manifold belong here: every test of moves then holds them.
struct ManifoldInvariants {
  topology::AbelianGroup homology;
  std::vector<std::tuple<int, bool>> links;  // Euler characteristic, orientable; no spheres
  std::ptrdiff_t spheres = 0;
  bool orientable = false;
  std::size_t components = 0;

  explicit ManifoldInvariants(const topology::Triangulation& triangulation)
      : homology(first_homology(triangulation)),
        orientable(triangulation.is_orientable()),
        components(triangulation.component_count()) {
    for (std::size_t v = 0; v < triangulation.vertex_count(); ++v) {
      const topology::VertexLink& link = triangulation.link(v);
      if (link.euler_characteristic == 2)
        ++spheres;
      else
        links.emplace_back(link.euler_characteristic, link.orientable);
    }
    std::ranges::sort(links);
  }
};

/// Fails fatally where the manifold is another, or where the number of finite vertices has not
/// changed by so many.
inline void expect_kept(const ManifoldInvariants& before, const ManifoldInvariants& after,
                        std::ptrdiff_t finite_vertices) {
  ASSERT_EQ(after.homology, before.homology);
  ASSERT_EQ(after.links, before.links);
  ASSERT_EQ(after.spheres, before.spheres + finite_vertices);
  ASSERT_EQ(after.orientable, before.orientable);
  ASSERT_EQ(after.components, before.components);
}

}  // namespace tripus::testing
