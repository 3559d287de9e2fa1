// Meshes of hyperbolic manifolds themselves: the identity is harmonic, with geodesic boundary.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "energies/harmonic.hpp"
#include "geometry/boost.hpp"
#include "parameterise/edges.hpp"
#include "parameterise/harmonic_map.hpp"
#include "parameterise/quality.hpp"
#include "tests/support/embedded_manifolds.hpp"

namespace tripus::parameterise {
namespace {

using geometry::lorentz_product;

Vector4 mean(const std::vector<Vector4>& points) {
  Vector4 sum = Vector4::Zero();
  for (const Vector4& point : points) sum += point;
  return geometry::on_hyperboloid(sum / std::sqrt(-lorentz_product(sum, sum)));
}

/// Tetrahedra that fill one truncated tetrahedron: its barycentric subdivision, where every
/// tetrahedron is cut into eight `refinements` times. Faces that are glued are cut alike.
struct Cell {
  std::vector<Vector4> points;
  std::vector<std::array<std::size_t, 4>> tetrahedra;
};

std::size_t number_of(Cell& cell, const Vector4& point) {
  for (std::size_t n = 0; n < cell.points.size(); ++n)
    if ((cell.points[n] - point).norm() < 1e-9) return n;
  cell.points.push_back(point);
  return cell.points.size() - 1;
}

/// Corners of a truncated tetrahedron: where edge ij meets the plane of vertex i.
Vector4 corner(const embedding::HyperboloidTetrahedron& t, std::size_t i, std::size_t j) {
  const Vector4 in_plane =
      t.vertices[j] - lorentz_product(t.vertices[j], t.vertices[i]) * t.vertices[i];
  const Vector4 place = in_plane / std::sqrt(-lorentz_product(in_plane, in_plane));
  return place[3] > 0 ? place : Vector4(-place);
}

Cell filled(const embedding::HyperboloidTetrahedron& t, int refinements) {
  Cell cell;
  std::map<std::pair<std::size_t, std::size_t>, Vector4> corners;
  std::vector<Vector4> all;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j)
      if (i != j) {
        corners[{i, j}] = corner(t, i, j);
        all.push_back(corners[{i, j}]);
      }
  // Faces as cycles of corners: truncations, and hexagons with a side for each edge and truncation.
  std::vector<std::vector<Vector4>> faces;
  for (std::size_t f = 0; f < 4; ++f) {
    const std::size_t a = (f + 1) % 4, b = (f + 2) % 4, c = (f + 3) % 4;
    faces.push_back({corners[{f, a}], corners[{f, b}], corners[{f, c}]});
    faces.push_back({corners[{a, b}], corners[{b, a}], corners[{b, c}], corners[{c, b}],
                     corners[{c, a}], corners[{a, c}]});
  }
  const std::size_t middle = number_of(cell, mean(all));
  for (const std::vector<Vector4>& face : faces) {
    const std::size_t centre = number_of(cell, mean(face));
    for (std::size_t k = 0; k < face.size(); ++k) {
      const Vector4& next = face[(k + 1) % face.size()];
      const std::size_t side = number_of(cell, mean({face[k], next}));
      for (const Vector4& end : {face[k], next})
        cell.tetrahedra.push_back({middle, centre, side, number_of(cell, end)});
    }
  }
  for (int n = 0; n < refinements; ++n) {
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> halves;
    const auto half = [&](std::size_t a, std::size_t b) {
      const auto [place, is_new] = halves.try_emplace(std::minmax(a, b), cell.points.size());
      if (is_new) cell.points.push_back(mean({cell.points[a], cell.points[b]}));
      return place->second;
    };
    std::vector<std::array<std::size_t, 4>> finer;
    for (const auto& [a, b, c, d] : cell.tetrahedra) {
      const std::size_t ab = half(a, b), ac = half(a, c), ad = half(a, d), bc = half(b, c),
                        bd = half(b, d), cd = half(c, d);
      finer.insert(finer.end(), {{a, ab, ac, ad},
                                 {b, ab, bc, bd},
                                 {c, ac, bc, cd},
                                 {d, ad, bd, cd},
                                 {ab, ac, ad, bd},
                                 {ab, ac, bc, bd},
                                 {ac, ad, bd, cd},
                                 {ac, bc, bd, cd}});
    }
    cell.tetrahedra = std::move(finer);
  }
  return cell;
}

/// The manifold in such tetrahedra: points in the frames of the cells that they were met in first.
struct Mesh {
  std::vector<energies::HarmonicEdge> edges;
  std::vector<Matrix4> isometries{Matrix4::Identity()};
  std::vector<Vector4> points, poles;
  double size = 0;  // longest edge
};

Mesh mesh_of(const testing::Embedded& manifold, int refinements) {
  const auto& embedded = manifold.embedding;
  const topology::Gluings& gluings = manifold.triangulation.gluings();
  std::vector<Cell> cells;
  for (const auto& t : embedded.tetrahedra) cells.push_back(filled(t, refinements));
  struct Place {
    std::size_t point;
    Matrix4 from_frame;  // of the point to that of the cell
  };
  std::vector<std::vector<std::optional<Place>>> places;
  for (const Cell& cell : cells) places.emplace_back(cell.points.size());
  Mesh mesh;
  for (std::size_t t = 0; t < cells.size(); ++t)
    for (std::size_t n = 0; n < cells[t].points.size(); ++n) {
      if (places[t][n]) continue;
      places[t][n] = Place{mesh.points.size(), Matrix4::Identity()};
      mesh.points.push_back(cells[t].points[n]);
      mesh.poles.emplace_back(Vector4::Zero());
      for (const Vector4& pole : embedded.tetrahedra[t].vertices)
        if (std::abs(lorentz_product(pole, cells[t].points[n])) < 1e-9) mesh.poles.back() = pole;
      std::vector<std::pair<std::size_t, std::size_t>> queue{{t, n}};
      for (std::size_t i = 0; i < queue.size(); ++i) {
        const auto [c, k] = queue[i];
        for (std::size_t f = 0; f < 4; ++f) {
          const Vector4& here = cells[c].points[k];
          if (std::abs(lorentz_product(embedded.tetrahedra[c].faces[f], here)) > 1e-9) continue;
          const Matrix4 back = geometry::lorentz_inverse(embedded.face_pairings[c][f]);
          const std::size_t other = gluings.neighbour(c, static_cast<int>(f));
          const Vector4 there = back * here;
          std::size_t m = 0;
          while (m < cells[other].points.size() && (cells[other].points[m] - there).norm() > 1e-8)
            ++m;
          if (m == cells[other].points.size()) {
            ADD_FAILURE() << "faces are not cut alike";
            return mesh;
          }
          if (places[other][m]) continue;
          places[other][m] = Place{places[c][k]->point, back * places[c][k]->from_frame};
          queue.emplace_back(other, m);
        }
      }
    }
  for (std::size_t t = 0; t < cells.size(); ++t)
    for (const auto& corners : cells[t].tetrahedra) {
      std::array<Vector4, 4> x;
      for (std::size_t v = 0; v < 4; ++v) x[v] = cells[t].points[corners[v]];
      // Flat, as seen from the middle.
      const Matrix4 seen = geometry::lorentz_inverse(geometry::boost(middle(x).head<3>()));
      std::array<geometry::Vector3, 4> flat;
      for (std::size_t v = 0; v < 4; ++v) {
        const geometry::Vector3 y = (seen * x[v]).head<3>();
        flat[v] = y * (std::asinh(y.norm()) / y.norm());
      }
      double volume = 0;
      const std::array<double, 6> weights = element_weights(flat, volume);
      for (std::size_t e = 0; e < 6; ++e) {
        const auto [i, j] = topology::kEdgeEnds[e];
        const Place& a = *places[t][corners[static_cast<std::size_t>(i)]];
        const Place& b = *places[t][corners[static_cast<std::size_t>(j)]];
        mesh.size =
            std::max(mesh.size, geometry::hyperbolic_distance(x[static_cast<std::size_t>(i)],
                                                              x[static_cast<std::size_t>(j)]));
        mesh.edges.push_back({static_cast<std::uint32_t>(a.point),
                              static_cast<std::uint32_t>(b.point),
                              static_cast<std::uint32_t>(mesh.isometries.size()), weights[e]});
        mesh.isometries.push_back(geometry::lorentz_inverse(a.from_frame) * b.from_frame);
      }
    }
  return mesh;
}

class HarmonicIdentity : public ::testing::TestWithParam<const char*> {};

TEST_P(HarmonicIdentity, IsTheMapOfAManifoldOntoItself) {
  const testing::Embedded manifold = *testing::try_embed(GetParam());
  double error = std::numeric_limits<double>::infinity();
  for (int refinements = 0; refinements <= 2; ++refinements) {
    const Mesh mesh = mesh_of(manifold, refinements);
    ASSERT_FALSE(::testing::Test::HasFailure());
    // From afar: every point begins in the middle of its frame's cell.
    const std::vector<Vector4> start(mesh.points.size(), geometry::origin());
    energies::HarmonicEnergy energy(mesh.edges, mesh.isometries, start, mesh.poles);
    const HarmonicMap map = minimised(energy);
    EXPECT_EQ(map.termination, solver::Termination::kConverged);
    for (std::size_t v = 0; v < mesh.points.size(); ++v)
      EXPECT_LT(geometry::hyperbolic_distance(map.points[v], mesh.points[v]), 0.08 * mesh.size);
    // The Dirichlet energy of the identity is 3/2 of the volume; of second order.
    const double now = map.energy - 1.5 * manifold.report.volume;
    EXPECT_LT(std::abs(now), 0.35 * error);
    error = std::abs(now);
  }
}

INSTANTIATE_TEST_SUITE_P(Manifolds, HarmonicIdentity,
                         ::testing::Values("cPcbbbihq", "dLQbcccdhkw", "eLPkbdcddmkkjb",
                                           "dLQbccchrqg"),  // the last is not orientable
                         [](const auto& parameter) { return std::string(parameter.param); });

}  // namespace
}  // namespace tripus::parameterise
