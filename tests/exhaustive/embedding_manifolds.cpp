// Laws E1 to E4 and E7 of embedding/README.md on all small geometric triangulations.
#include <cmath>
#include <numbers>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "embedding/holonomy.hpp"
#include "embedding/moebius_gluing.hpp"
#include "embedding/tessellate.hpp"
#include "geometry/circle_packing.hpp"
#include "tests/support/embedded_manifolds.hpp"

namespace tripus {
namespace {

using geometry::CirclePacking;
using geometry::HyperboloidTetrahedron;
using geometry::lorentz_product;
using geometry::Matrix4;
using geometry::Vector4;
using testing::Embedded;

constexpr std::size_t kStep = 13;  // of triangulations-4.txt

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, value);
  return result;
}

TEST(EmbeddedManifolds, EdgesCloseUpForEveryPublishedManifold) {
  std::size_t count = 0;
  for (const testing::Row& row : testing::compact_manifolds()) {
    const auto embedded = testing::try_embed(row.at("isosig"));
    ASSERT_TRUE(embedded) << row.at("isosig");
    EXPECT_LT(largest(embedding::edge_defects(embedded->embedding, embedded->triangulation)), 1e-10)
        << row.at("isosig");
    ++count;
  }
  EXPECT_EQ(count, 158u);
}

TEST(EmbeddedManifolds, TetrahedraHaveTheirGramMatricesAndHoldTheirCentres) {  // E1
  testing::for_geometric_triangulations(kStep, [](const std::string& name, const Embedded& m,
                                                  bool) {
    for (std::size_t t = 0; t < m.triangulation.tetrahedron_count(); ++t) {
      const HyperboloidTetrahedron& tetrahedron = m.embedding.tetrahedra[t];
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector4& v = tetrahedron.vertices[i];
        const Vector4& n = tetrahedron.faces[i];
        EXPECT_NEAR(lorentz_product(v, v), 1, 1e-12 * v.squaredNorm()) << name;
        EXPECT_NEAR(lorentz_product(n, n), 1, 1e-12 * n.squaredNorm()) << name;
        EXPECT_GT(v[3], 0) << name;  // <origin, v> < 0
        EXPECT_GT(n[3], 0) << name;
        EXPECT_LT(lorentz_product(n, v), 0) << name;
        for (std::size_t j = 0; j < 4; ++j) {
          if (i == j) continue;
          const Vector4& w = tetrahedron.vertices[j];
          const int edge = topology::kEdgeNumber[i][j];
          const double l = m.report.edge_lengths[m.triangulation.edge_class(t, edge)];
          EXPECT_NEAR(lorentz_product(v, w), -std::cosh(l), 1e-14 * v.norm() * w.norm()) << name;
          EXPECT_NEAR(lorentz_product(n, w), 0, 1e-14 * n.norm() * w.norm()) << name;
        }
      }
    }
  });
}

TEST(EmbeddedManifolds, PairingsMatchFacesAndCloseUpAroundEdges) {  // E2
  std::size_t sampled = 0;
  testing::for_geometric_triangulations(
      kStep, [&](const std::string& name, const Embedded& m, bool large) {
        const topology::Gluings& gluings = m.triangulation.gluings();
        for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
          for (int f = 0; f < 4; ++f) {
            const Matrix4& a = m.embedding.face_pairings[t][static_cast<std::size_t>(f)];
            const auto& here = m.embedding.tetrahedra[t];
            const auto& there = m.embedding.tetrahedra[gluings.neighbour(t, f)];
            const topology::Perm4 p = gluings.gluing(t, f);
            for (int v = 0; v < 4; ++v) {
              const auto image = static_cast<std::size_t>(p(v)), own = static_cast<std::size_t>(v);
              if (v == f) {
                EXPECT_LT((a * there.faces[image] + here.faces[own]).norm(), 1e-11) << name;
              } else {
                EXPECT_LT((a * there.vertices[image] - here.vertices[own]).norm(), 1e-11) << name;
              }
            }
            if (m.triangulation.is_orientable()) {
              EXPECT_GT(a.determinant(), 0) << name;
            }
          }
        }
        EXPECT_LT(largest(embedding::edge_defects(m.embedding, m.triangulation)), 1e-10) << name;
        sampled += large;
      });
  EXPECT_GT(sampled, 200u);
}

TEST(EmbeddedManifolds, HolonomyIsARepresentation) {  // E3
  testing::for_geometric_triangulations(
      kStep, [](const std::string& name, const Embedded& m, bool) {
        const embedding::Holonomy holonomy = embedding::holonomy(m.embedding, m.triangulation);
        EXPECT_EQ(holonomy.isometries.size(), m.triangulation.tetrahedron_count() + 1) << name;
        EXPECT_LT(largest(embedding::relator_defects(holonomy)), 1e-9) << name;
        EXPECT_EQ(holonomy.orientable, m.triangulation.is_orientable()) << name;
        // In SL(2,C), up to sign, too.
        for (const topology::Word& relator : holonomy.group.presentation.relators) {
          geometry::MoebiusMap product;
          for (const topology::Letter letter : relator) {
            const auto& map = holonomy.moebius[topology::generator_of(letter)];
            product = product * (letter > 0 ? map : inverse(map));
          }
          EXPECT_LT(geometry::difference(product, {}), 1e-9) << name;
        }
      });
}

TEST(EmbeddedManifolds, CirclesMeetAtTheDihedralAngles) {  // E4
  testing::for_geometric_triangulations(
      kStep, [](const std::string& name, const Embedded& m, bool) {
        for (const auto& theta : m.report.dihedral_angles) {
          const CirclePacking packing = geometry::circle_packing(theta);
          for (std::size_t e = 0; e < 6; ++e) {
            const auto& faces = topology::kEdgeEnds[5 - e];  // the two faces at an edge
            EXPECT_NEAR(geometry::intersection_angle(packing.faces[std::size_t(faces[0])],
                                                     packing.faces[std::size_t(faces[1])]),
                        theta[e], 1e-12)
                << name;
          }
          for (std::size_t v = 0; v < 4; ++v)
            for (std::size_t f = 0; f < 4; ++f)
              if (v != f) {
                EXPECT_NEAR(geometry::intersection_angle(packing.vertices[v], packing.faces[f]),
                            std::numbers::pi / 2, 1e-12)
                    << name;
              }
        }
      });
}

TEST(EmbeddedManifolds, CirclePackingsAreTheTetrahedraElsewhere) {  // E4
  testing::for_geometric_triangulations(kStep, [](const std::string& name, const Embedded& m,
                                                  bool) {
    for (std::size_t t = 0; t < m.embedding.tetrahedra.size(); ++t) {
      const CirclePacking packing = geometry::circle_packing(m.report.dihedral_angles[t]);
      CirclePacking own = geometry::circles_of(m.embedding.tetrahedra[t]);
      Matrix4 vertices;
      for (int v = 0; v < 4; ++v)
        vertices.col(v) = m.embedding.tetrahedra[t].vertices[static_cast<std::size_t>(v)];
      if (vertices.determinant() < 0) own = geometry::mirrored(own);
      // Three points of one face fix the isometry; all eight circles must then agree.
      const geometry::MoebiusMap map =
          geometry::map_of_triples(embedding::face_circle_points(packing, {0, 1, 2}),
                                   embedding::face_circle_points(own, {0, 1, 2}));
      for (std::size_t i = 0; i < 4; ++i) {
        EXPECT_LT((plane_of(apply(map, packing.faces[i])) - plane_of(own.faces[i])).norm(), 1e-11)
            << name;
        EXPECT_LT((plane_of(apply(map, packing.vertices[i])) - plane_of(own.vertices[i])).norm(),
                  1e-11)
            << name;
      }
    }
  });
}

TEST(EmbeddedManifolds, MoebiusGluingsAreTheMatrices) {  // E4
  testing::for_geometric_triangulations(
      kStep, [](const std::string& name, const Embedded& m, bool) {
        const topology::Gluings& gluings = m.triangulation.gluings();
        for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
          for (int f = 0; f < 4; ++f) {
            const Matrix4& pairing = m.embedding.face_pairings[t][static_cast<std::size_t>(f)];
            const geometry::MoebiusMap map = embedding::moebius_face_pairing(
                circles_of(m.embedding.tetrahedra[t]),
                circles_of(m.embedding.tetrahedra[gluings.neighbour(t, f)]), gluings.gluing(t, f),
                f, pairing.determinant() < 0);
            EXPECT_LT((to_matrix(map) - pairing).cwiseAbs().maxCoeff(), 1e-12) << name;
          }
        }
      });
}

TEST(EmbeddedManifolds, TruncationsFillTheBoundary) {  // E7
  testing::for_geometric_triangulations(
      kStep, [](const std::string& name, const Embedded& m, bool) {
        std::vector<double> area(m.triangulation.vertex_count(), 0.0);
        for (std::size_t t = 0; t < m.embedding.tetrahedra.size(); ++t) {
          for (int v = 0; v < 4; ++v) {
            std::array<Vector4, 3> corners;
            std::size_t n = 0;
            for (int w = 0; w < 4; ++w)
              if (w != v) corners[n++] = geometry::corner(m.embedding.tetrahedra[t], v, w);
            area[m.triangulation.vertex_class(t, v)] +=
                embedding::triangle_area(corners[0], corners[1], corners[2]);
          }
        }
        for (std::size_t v = 0; v < area.size(); ++v) {
          const double chi = m.triangulation.link(v).euler_characteristic;
          EXPECT_NEAR(area[v], -2 * std::numbers::pi * chi, 1e-12) << name;
        }
      });
}

}  // namespace
}  // namespace tripus
