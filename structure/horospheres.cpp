#include "structure/horospheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <Eigen/Sparse>
#include <Eigen/SparseCholesky>

#include "geometry/mixed_tetrahedron.hpp"

namespace tripus::structure {
namespace {

using topology::Triangulation;
using topology::VertexKind;

double diagonal_of(VertexKind kind) {
  return kind == VertexKind::kHyperideal ? 1 : kind == VertexKind::kIdeal ? 0 : -1;
}

}  // namespace

std::vector<double> horosphere_areas(const Triangulation& triangulation,
                                     const energies::CoVolumeAt& at) {
  const std::span<const double> x = at.lengths();
  std::vector<double> areas(triangulation.vertex_count());
  const auto links = at.energy().links();
  std::vector<double> entry(x.size());  // -G_ij of the edge classes
  for (std::size_t e = 0; e < x.size(); ++e) {
    const auto corner = triangulation.corners(e)[0];
    const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    const auto kind = [&](int end) {
      return links[triangulation.vertex_class(corner.tetrahedron(), end)].kind;
    };
    entry[e] = geometry::gram_entry(x[e], diagonal_of(kind(ends[0])), diagonal_of(kind(ends[1])))
                   .minus_gram;
  }
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    std::array<double, 4> d;
    for (std::size_t v = 0; v < 4; ++v)
      d[v] = diagonal_of(links[triangulation.vertex_class(t, static_cast<int>(v))].kind);
    if (std::ranges::find(d, 0.0) == d.end()) continue;
    const auto theta = at.dihedral_angles(t);
    const auto minus_gram = [&](std::size_t i, std::size_t j) {
      return entry[triangulation.edge_class(t, topology::kEdgeNumber[i][j])];
    };
    for (std::size_t i = 0; i < 4; ++i) {
      if (d[i] != 0) continue;
      // The triangle cut off by the horosphere, docs/theory.md (80): two sides and their angle.
      const std::size_t j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
      const auto squared_side = [&](std::size_t a, std::size_t b) {
        const double inverse_a = 1 / minus_gram(i, a), inverse_b = 1 / minus_gram(i, b);
        return d[a] * (inverse_a * inverse_a) + d[b] * (inverse_b * inverse_b) +
               2 * minus_gram(a, b) * (inverse_a * inverse_b);
      };
      const int edge = topology::kEdgeNumber[i][j];
      areas[triangulation.vertex_class(t, static_cast<int>(i))] +=
          std::sqrt(squared_side(j, k)) * std::sqrt(squared_side(j, l)) *
          std::sin(theta[static_cast<std::size_t>(edge)]) / 2;
    }
  }
  return areas;
}

void set_horospheres(const Triangulation& triangulation, const energies::CoVolumeAt& at,
                     std::span<double> x) {
  const std::vector<double> areas = horosphere_areas(triangulation, at);
  std::vector<double> shift(areas.size());
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (at.energy().links()[v].kind != VertexKind::kIdeal) continue;
    shift[v] = std::log(areas[v] / kHorosphereArea) / 2;
    if (!std::isfinite(shift[v])) return;
  }
  for (std::size_t e = 0; e < x.size(); ++e) {
    const auto corner = triangulation.corners(e)[0];
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      x[e] += shift[triangulation.vertex_class(corner.tetrahedron(), end)];
  }
}

void remove_horosphere_shifts(const Triangulation& triangulation, const energies::CoVolume& energy,
                              std::span<double> g) {
  // The column of a cusp counts the ends of each edge there; least squares along these columns.
  std::vector<int> column(triangulation.vertex_count(), -1);
  int cusps = 0;
  for (std::size_t v = 0; v < column.size(); ++v)
    if (energy.links()[v].kind == VertexKind::kIdeal) column[v] = cusps++;
  if (cusps == 0) return;
  const auto columns_of = [&](std::size_t e) {
    const auto corner = triangulation.corners(e)[0];
    const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    return std::array{column[triangulation.vertex_class(corner.tetrahedron(), ends[0])],
                      column[triangulation.vertex_class(corner.tetrahedron(), ends[1])]};
  };
  constexpr int kFew = 8;
  if (cusps <= kFew) {
    Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kFew, kFew> products;
    Eigen::Matrix<double, Eigen::Dynamic, 1, 0, kFew, 1> along;
    products.setZero(cusps, cusps);
    along.setZero(cusps);
    for (std::size_t e = 0; e < g.size(); ++e) {
      const auto [a, b] = columns_of(e);
      if (a >= 0) along(a) += g[e];
      if (b >= 0) along(b) += g[e];
      if (a >= 0) products(a, a) += 1;
      if (b >= 0) products(b, b) += 1;
      if (a < 0 || b < 0) continue;
      products(a, b) += 1;
      products(b, a) += 1;
    }
    products.llt().solveInPlace(along);
    for (std::size_t e = 0; e < g.size(); ++e) {
      const auto [a, b] = columns_of(e);
      g[e] -= (a < 0 ? 0 : along(a)) + (b < 0 ? 0 : along(b));
    }
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < g.size(); ++e)
    for (const int c : columns_of(e))
      if (c >= 0) entries.emplace_back(static_cast<int>(e), c, 1.0);
  Eigen::SparseMatrix<double> ends(static_cast<Eigen::Index>(g.size()), cusps);
  ends.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> products = ends.transpose() * ends;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(products);
  Eigen::Map<Eigen::VectorXd> gradient(g.data(), static_cast<Eigen::Index>(g.size()));
  const Eigen::VectorXd along = factor.solve(ends.transpose() * gradient);
  gradient -= ends * along;
}

}  // namespace tripus::structure
