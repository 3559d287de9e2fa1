// The sums of docs/theory.md section 6 away from the metric, at any lengths.
#include <numbers>
#include <random>

#include <gtest/gtest.h>

#include "energies/co_volume.hpp"
#include "geometry/curvature.hpp"
#include "geometry/truncated_tetrahedron.hpp"
#include "tests/support/data_files.hpp"
#include "topology/isosig.hpp"

namespace tripus {
namespace {

/// Areas of the links [V] at lengths x, and the edge curvatures K [E].
struct Surfaces {
  std::vector<double> area, curvature;
};

Surfaces surfaces_at(const topology::Triangulation& triangulation, const std::vector<double>& x) {
  const energies::CoVolume energy(triangulation);
  const auto at = energy.at(x);
  Surfaces s;
  s.curvature.assign(at.gradient().begin(), at.gradient().end());
  for (double& k : s.curvature) k = -k;
  s.area.resize(triangulation.vertex_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto theta = at.dihedral_angles(t);
    for (int v = 0; v < 4; ++v) {
      const auto& edges = geometry::kEdgesAtVertex[std::size_t(v)];
      s.area[triangulation.vertex_class(t, v)] += geometry::truncation_area(
          theta[std::size_t(edges[0])], theta[std::size_t(edges[1])], theta[std::size_t(edges[2])]);
    }
  }
  return s;
}

// (45): over the edge ends at a hyperideal vertex, sum K = 2 pi chi(link) + area(link).
TEST(Sums, OfCurvaturesAtEveryHyperidealVertex) {
  std::mt19937_64 random(31);
  std::uniform_real_distribution<double> length(0.2, 1.5);
  std::size_t checked = 0;
  for (const char* file :
       {"triangulations-2.txt", "triangulations-3.txt", "triangulations-4.txt"}) {
    for (const auto& signature : testing::data_lines(file)) {
      const topology::Triangulation triangulation(topology::decode_isosig(signature));
      std::vector<double> x(triangulation.edge_count());
      for (double& l : x) l = length(random);
      const Surfaces s = surfaces_at(triangulation, x);
      std::vector<double> sum(triangulation.vertex_count());
      for (std::size_t e = 0; e < x.size(); ++e) {
        const topology::EdgeCorner corner = triangulation.corners(e).front();
        for (const int end : topology::kEdgeEnds[std::size_t(corner.edge())])
          sum[triangulation.vertex_class(corner.tetrahedron(), end)] += s.curvature[e];
      }
      for (std::size_t v = 0; v < sum.size(); ++v) {
        const double expected =
            2 * std::numbers::pi * triangulation.link(v).euler_characteristic + s.area[v];
        EXPECT_NEAR(sum[v], expected, 1e-11) << signature;
        ++checked;
      }
    }
  }
  EXPECT_GE(checked, 11296u);
}

// (44): at a finite vertex sum K = 4 pi - sum of the solid angles. A closed triangulation has only
// finite vertices, and the identity is combinatorial: any angles will do.
TEST(Sums, OfCurvaturesAtAFiniteVertex) {
  // The Poincare homology sphere with one vertex (Regina 7.3, Example3.poincare).
  const topology::Triangulation sphere(topology::decode_isosig("fvPQcdecedekrsnrs"));
  std::mt19937_64 random(32);
  std::uniform_real_distribution<double> angle(0.1, 2.5);
  std::vector<std::array<double, 6>> theta(sphere.tetrahedron_count());
  for (auto& six : theta)
    for (double& a : six) a = angle(random);
  std::vector<double> sum(sphere.vertex_count());
  for (std::size_t e = 0; e < sphere.edge_count(); ++e) {
    std::vector<double> around;
    for (const auto corner : sphere.corners(e))
      around.push_back(theta[corner.tetrahedron()][std::size_t(corner.edge())]);
    const auto corner = sphere.corners(e).front();
    for (const int end : topology::kEdgeEnds[std::size_t(corner.edge())])
      sum[sphere.vertex_class(corner.tetrahedron(), end)] += geometry::edge_curvature(around);
  }
  std::vector<std::vector<double>> solid(sphere.vertex_count());
  for (std::size_t t = 0; t < theta.size(); ++t) {
    for (int v = 0; v < 4; ++v) {
      const auto& edges = geometry::kEdgesAtVertex[std::size_t(v)];
      solid[sphere.vertex_class(t, v)].push_back(
          geometry::solid_angle(theta[t][std::size_t(edges[0])], theta[t][std::size_t(edges[1])],
                                theta[t][std::size_t(edges[2])]));
    }
  }
  for (std::size_t v = 0; v < sum.size(); ++v) {
    ASSERT_EQ(sphere.link(v).euler_characteristic, 2);
    EXPECT_NEAR(sum[v], geometry::vertex_curvature(solid[v]), 1e-12);
  }
}

}  // namespace
}  // namespace tripus
