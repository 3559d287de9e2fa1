// Laws E1 to E3 and E5 to E7 of embedding/README.md with vertices of every kind, cone angles and
// gluings that reverse orientation.
#include <cmath>
#include <random>
#include <set>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "base/error.hpp"
#include "embedding/holonomy.hpp"
#include "embedding/tessellate.hpp"
#include "geometry/mixed_tetrahedron.hpp"
#include "structure/horospheres.hpp"
#include "tests/support/data_files.hpp"
#include "tests/support/embedded_manifolds.hpp"
#include "tests/support/orb_examples.hpp"

namespace tripus::embedding {
namespace {

using geometry::lorentz_product;
using geometry::Matrix4;
using geometry::Vector4;
using topology::ConeAngle;
using topology::Triangulation;

struct Placed {
  std::string name;
  Triangulation triangulation;
  structure::Report report;
  Embedding embedding;
};

Placed placed(const std::string& name, Triangulation triangulation,
              std::vector<ConeAngle> cone_angles = {}, double area = 0) {
  structure::SolveOptions options;
  options.evidence = false;
  options.cone_angles = cone_angles;
  structure::Report report = structure::solve(triangulation, options);
  if (report.outcome != structure::Outcome::kGeometric) throw std::runtime_error(name);
  Embedding embedding = embed(triangulation, report.edge_lengths, {std::move(cone_angles), area});
  return {name, std::move(triangulation), std::move(report), std::move(embedding)};
}

Placed placed(const std::string& isosig, std::vector<ConeAngle> cone_angles = {}, double area = 0) {
  return placed(isosig, Triangulation(topology::decode_isosig(isosig)), std::move(cone_angles),
                area);
}

/// SnapPy's 415 manifolds, those with cusps and boundary, Gieseking's, Orb's orbifolds, and
/// manifolds whose geodesic boundary is not orientable.
template <class Visit>
void for_every_kind(Visit visit) {
  visit(placed("bkaaid"));
  for (const auto& row : testing::data_table("cusped-census-5.tsv"))
    visit(placed(row.at("isosig")));
  for (const std::string& line : testing::data_lines("triangulations-cusped.txt")) {
    const Triangulation m(topology::decode_isosig(line));
    structure::SolveOptions options;
    options.evidence = false;
    if (structure::solve(m, options).outcome == structure::Outcome::kGeometric) visit(placed(line));
  }
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("solution") != "geometric_solution") continue;
    testing::Labelled example = testing::orb_example(row);
    visit(placed(row.at("name"), std::move(example.triangulation), example.cone_angles));
  }
}

double largest(const std::vector<double>& values) {
  double result = 0;
  for (const double value : values) result = std::max(result, value);
  return result;
}

TEST(EveryKind, TetrahedraHaveTheirGramMatricesAndFitTogether) {  // E1, E2, E3
  std::size_t count = 0, finite = 0, reversing = 0, singular = 0;
  for_every_kind([&](const Placed& m) {
    SCOPED_TRACE(m.name);
    ++count;
    const topology::Gluings& gluings = m.triangulation.gluings();
    bool has_finite = false, reverses = false;
    for (std::size_t t = 0; t < gluings.tetrahedron_count(); ++t) {
      const HyperboloidTetrahedron& here = m.embedding.tetrahedra[t];
      for (std::size_t i = 0; i < 4; ++i) {
        const Vector4 &v = here.vertices[i], &n = here.faces[i];
        has_finite |= here.is_finite(i);
        EXPECT_NEAR(lorentz_product(v, v), here.diagonal[i], 1e-12 * v.squaredNorm());
        EXPECT_NEAR(lorentz_product(n, n), 1, 1e-12 * n.squaredNorm());
        EXPECT_GT(v[3], 0);
        EXPECT_GT(n[3], 0);
        for (std::size_t j = 0; j < 4; ++j) {
          if (i == j) continue;
          const Vector4& w = here.vertices[j];
          EXPECT_NEAR(lorentz_product(n, w), 0, 1e-13 * n.norm() * w.norm());
          // Lengths are those reported but for the move from one horosphere to the other.
          const double moved =
              std::log(structure::kHorosphereArea / m.embedding.horosphere_area) / 2;
          const double l =
              m.report.edge_lengths[m.triangulation.edge_class(t, topology::kEdgeNumber[i][j])] +
              (here.is_ideal(i) + here.is_ideal(j) > 0
                   ? moved * (here.is_ideal(i) + here.is_ideal(j))
                   : 0);
          const double g = geometry::gram_entry(l, here.diagonal[i], here.diagonal[j]).minus_gram;
          EXPECT_NEAR(lorentz_product(v, w), -g, 1e-13 * v.norm() * w.norm());
        }
      }
      for (int f = 0; f < 4; ++f) {
        const Matrix4& a = m.embedding.face_pairings[t][static_cast<std::size_t>(f)];
        const auto& there = m.embedding.tetrahedra[gluings.neighbour(t, f)];
        const topology::Perm4 p = gluings.gluing(t, f);
        reverses |= a.determinant() < 0;
        for (int v = 0; v < 4; ++v) {
          const auto image = static_cast<std::size_t>(p(v)), own = static_cast<std::size_t>(v);
          if (v == f) {
            EXPECT_LT((a * there.faces[image] + here.faces[own]).norm(), 1e-9);
          } else {
            // For ideal vertices too: the null vectors agree and not only their directions, so the
            // structure at the cusps is complete.
            EXPECT_LT((a * there.vertices[image] - here.vertices[own]).norm(), 1e-9);
          }
        }
      }
      singular += m.embedding.singular_edges[t] != 0;
    }
    finite += has_finite;
    reversing += reverses;
    EXPECT_EQ(reverses, !m.triangulation.is_orientable());
    EXPECT_LT(largest(edge_defects(m.embedding, m.triangulation)), 1e-9);
    const Holonomy group = holonomy(m.embedding, m.triangulation);
    EXPECT_LT(largest(relator_defects(group)), 1e-6);
    EXPECT_EQ(group.orientable, m.triangulation.is_orientable());
    const std::vector<double> areas = horosphere_areas(m.embedding, m.triangulation);
    for (std::size_t v = 0; v < areas.size(); ++v) {
      const bool cusp = m.report.vertices[v].kind == topology::VertexKind::kIdeal;
      EXPECT_NEAR(areas[v], cusp ? m.embedding.horosphere_area : 0, 1e-11);
    }
  });
  EXPECT_EQ(count, 530u);
  EXPECT_EQ(finite, 13u);
  EXPECT_GT(reversing, 100u);
  EXPECT_GT(singular, 40u);
}

/// The volume of the cells: the middles of many triangles, and its extrapolation.
double volume_of(const HyperboloidTetrahedron& tetrahedron) {
  double value[3];
  for (int n = 0; n < 3; ++n) {
    const CellShape shape = cell_shape(tetrahedron, n + 2);
    std::vector<Vector3> places;
    for (const Vector4& point : shape.points)
      places.push_back(geometry::to_model(Model::kKleinBall, point));
    value[n] = enclosed_volume(places, shape.triangles);
  }
  // Chords of a horosphere are off by the square of their length, and by the fourth power.
  const double first = (4 * value[1] - value[0]) / 3, second = (4 * value[2] - value[1]) / 3;
  return (16 * second - first) / 15;
}

/// The rectangles that the horospheres of parabolic edges cut off.
double parabolic_area(const HyperboloidTetrahedron& tetrahedron) {
  double area = 0;
  for (std::size_t e = 0; e < 6; ++e) {
    if (!tetrahedron.is_parabolic(e)) continue;
    const auto [i, j] = std::pair(topology::kEdgeEnds[e][0], topology::kEdgeEnds[e][1]);
    const auto [k, l] = std::pair(topology::kEdgeEnds[5 - e][0], topology::kEdgeEnds[5 - e][1]);
    const Vector4 corner = geometry::parabolic_corner(tetrahedron, i, j, k);
    const Vector4 along = geometry::parabolic_corner(tetrahedron, j, i, k) - corner;
    const Vector4 across = geometry::parabolic_corner(tetrahedron, i, j, l) - corner;
    EXPECT_NEAR(lorentz_product(along, across), 0, 1e-10);
    area += std::sqrt(lorentz_product(along, along) * lorentz_product(across, across));
  }
  return area;
}

TEST(EveryKind, CellsAndCuspsHaveTheVolumeOfTheFormula) {  // E6, E7
  std::size_t n = 0;
  for_every_kind([&](const Placed& m) {
    if (n++ % 4 != 0 && m.triangulation.tetrahedron_count() > 3) return;
    SCOPED_TRACE(m.name);
    double volume = 0, cusps = 0;
    for (const HyperboloidTetrahedron& tetrahedron : m.embedding.tetrahedra)
      volume += volume_of(tetrahedron);
    // A cusp beyond a horosphere of area A has the volume A / 2.
    for (const double area : horosphere_areas(m.embedding, m.triangulation)) cusps += area / 2;
    for (const HyperboloidTetrahedron& tetrahedron : m.embedding.tetrahedra)
      cusps += parabolic_area(tetrahedron) / 2;
    EXPECT_NEAR(volume + cusps, m.report.volume, 2e-4 * m.report.volume);
  });
}

TEST(EveryKind, CellsAreClosedAndFaceOutward) {  // E6
  std::size_t n = 0;
  for_every_kind([&](const Placed& m) {
    if (n++ % 9 != 0) return;
    SCOPED_TRACE(m.name);
    std::vector<Cell> cells;
    if (m.embedding.develops())
      cells = universal_cover(m.embedding, m.triangulation, {.max_cells = 12});
    else
      cells.push_back({0, Matrix4::Identity()});
    for (const Model model : {Model::kUpperHalfSpace, Model::kPoincareBall, Model::kKleinBall}) {
      const Tessellation tessellation(m.embedding, cells, {model, 0.02});
      std::size_t points = 0, triangles = 0;
      for (std::size_t c = 0; c < cells.size(); ++c) {
        const auto places = tessellation.points(c);
        const auto shape = tessellation.triangles(c);
        std::set<std::pair<std::uint32_t, std::uint32_t>> sides;
        double volume = 0;
        for (const auto& t : shape) {
          for (std::size_t s = 0; s < 3; ++s)
            EXPECT_TRUE(sides.insert({t[s], t[(s + 1) % 3]}).second);
          volume += places[t[0]].dot(places[t[1]].cross(places[t[2]]));
        }
        for (const auto& [from, to] : sides) EXPECT_TRUE(sides.contains({to, from}));
        EXPECT_GT(volume, 0) << to_string(model) << ' ' << c;
        points += places.size();
        triangles += shape.size();
      }
      EXPECT_EQ(tessellation.point_count(), points);
      EXPECT_EQ(tessellation.triangle_count(), triangles);
    }
  });
}

/// Points at random of a ball around the root lie in one cell each: those of the radius fill it,
/// and none is there twice.
void expect_tiling(const Placed& m, double radius) {
  SCOPED_TRACE(m.name);
  const UniversalCover cover = grow_universal_cover(m.embedding, m.triangulation,
                                                    {.max_cells = 200000, .max_radius = radius});
  ASSERT_EQ(cover.end, CoverEnd::kComplete);
  std::mt19937_64 random(3);
  const auto unit = [&] { return static_cast<double>(random() >> 11) * 0x1p-53; };
  std::size_t inside = 0;
  for (int n = 0; n < 300; ++n) {
    const double r = radius * unit(), z = 2 * unit() - 1, phi = 7 * unit();
    const double rho = std::sinh(r) * std::sqrt(1 - z * z);
    const Vector4 x(rho * std::cos(phi), rho * std::sin(phi), std::sinh(r) * z, std::cosh(r));
    std::size_t cells = 0;
    for (const Cell& cell : cover.cells) {
      const Vector4 own = geometry::lorentz_inverse(cell.isometry) * x;
      const HyperboloidTetrahedron& tetrahedron = m.embedding.tetrahedra[cell.tetrahedron];
      bool here = true;
      for (std::size_t i = 0; i < 4 && here; ++i)
        here =
            lorentz_product(own, tetrahedron.faces[i]) <= 0 &&
            (!tetrahedron.is_hyperideal(i) || lorentz_product(own, tetrahedron.vertices[i]) <= 0);
      cells += here;
    }
    EXPECT_LE(cells, 1u);
    inside += cells;
  }
  const bool boundary = std::ranges::any_of(
      m.report.vertices, [](const auto& v) { return v.kind == topology::VertexKind::kHyperideal; });
  // Beyond geodesic boundary there is nothing.
  if (boundary)
    EXPECT_GT(inside, 30u);
  else
    EXPECT_EQ(inside, 300u);
}

TEST(EveryKind, UniversalCoversFillSpaceOnce) {  // E5
  for (const char* cusped : {"bkaaid", "cPcbbbiht", "cPcbbbdxm", "dLQacccjjkg"})
    expect_tiling(placed(cusped), 2.5);
  const ConeAngle two = ConeAngle::rational(1, 1), three = ConeAngle::rational(2, 3);
  expect_tiling(placed("cPcbbbiht", {two, two}), 2);
  expect_tiling(placed("cPcbbbihq", {three}), 2);
  int finite = 0;
  for (const auto& row : testing::data_table("orb-examples.tsv")) {
    if (row.at("solution") != "geometric_solution") continue;
    testing::Labelled example = testing::orb_example(row);
    const bool is_finite = row.at("finite_vertices") == "yes";
    if (example.triangulation.tetrahedron_count() > (is_finite ? 8u : 2u)) continue;
    finite += is_finite;
    expect_tiling(placed(row.at("name"), std::move(example.triangulation), example.cone_angles),
                  1.5);
  }
  EXPECT_GE(finite, 3);
}

TEST(EveryKind, HorospheresAreThoseAskedFor) {
  const Placed small = placed("cPcbbbiht", {}, 0.25);
  EXPECT_NEAR(horosphere_areas(small.embedding, small.triangulation)[0], 0.25, 1e-14);
  // The two regular ideal tetrahedra: the horosphere touches itself at area 2 sqrt(3), where every
  // edge has length 0.
  const Placed largest = placed("cPcbbbiht", {}, 2 * std::sqrt(3.0) - 1e-9);
  EXPECT_NEAR(lorentz_product(largest.embedding.tetrahedra[0].vertices[0],
                              largest.embedding.tetrahedra[0].vertices[1]),
              -2, 1e-8);
  EXPECT_THROW(placed("cPcbbbiht", {}, 3.5), InvalidInput);
  EXPECT_THROW(placed("cPcbbbiht", {}, -1), InvalidInput);
}

TEST(EveryKind, WhatDoesNotDevelopIsRefusedByName) {
  const Placed m = placed("cPcbbbihq", {ConeAngle(4.0)});
  EXPECT_FALSE(m.embedding.develops());
  EXPECT_LT(largest(edge_defects(m.embedding, m.triangulation)), 1e-12);
  EXPECT_THROW(universal_cover(m.embedding, m.triangulation), Unsupported);
  // Without the edge the group is free of rank 3; no relator is left.
  EXPECT_TRUE(holonomy(m.embedding, m.triangulation).group.presentation.relators.empty());
  const Triangulation tripus(topology::decode_isosig("cPcbbbihq"));
  EXPECT_THROW(embed(tripus, std::vector<double>{0.0}), InvalidInput);
  EXPECT_THROW(embed(tripus, std::vector<double>{0.1}, {{ConeAngle::rational(0, 1)}, 0}),
               InvalidInput);
}

}  // namespace
}  // namespace tripus::embedding
