#include "structure/horospheres.hpp"

#include <algorithm>
#include <array>
#include <cmath>

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
                                     const energies::CoVolume& energy, std::span<const double> x) {
  std::vector<double> areas(triangulation.vertex_count());
  const auto links = energy.links();
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto theta = energy.dihedral_angles(t);
    std::array<double, 4> d;
    for (std::size_t v = 0; v < 4; ++v)
      d[v] = diagonal_of(links[triangulation.vertex_class(t, static_cast<int>(v))].kind);
    if (std::ranges::find(d, 0.0) == d.end()) continue;
    std::array<double, 6> entries;
    for (std::size_t e = 0; e < 6; ++e) {
      const auto ends = topology::kEdgeEnds[e];
      entries[e] = geometry::gram_entry(x[triangulation.edge_class(t, static_cast<int>(e))],
                                        d[static_cast<std::size_t>(ends[0])],
                                        d[static_cast<std::size_t>(ends[1])])
                       .minus_gram;
    }
    const auto minus_gram = [&](std::size_t i, std::size_t j) {
      return entries[static_cast<std::size_t>(topology::kEdgeNumber[i][j])];
    };
    for (std::size_t i = 0; i < 4; ++i) {
      if (d[i] != 0) continue;
      // The triangle cut off by the horosphere, docs/theory.md (80): two sides and their angle.
      const std::size_t j = (i + 1) % 4, k = (i + 2) % 4, l = (i + 3) % 4;
      const auto side = [&](std::size_t a, std::size_t b) {
        const double e_a = minus_gram(i, a), e_b = minus_gram(i, b);
        return std::sqrt(d[a] / (e_a * e_a) + d[b] / (e_b * e_b) +
                         2 * minus_gram(a, b) / (e_a * e_b));
      };
      const int edge = topology::kEdgeNumber[i][j];
      areas[triangulation.vertex_class(t, static_cast<int>(i))] +=
          side(j, k) * side(j, l) * std::sin(theta[static_cast<std::size_t>(edge)]) / 2;
    }
  }
  return areas;
}

void set_horospheres(const Triangulation& triangulation, const energies::CoVolume& energy,
                     std::span<double> x) {
  const std::vector<double> areas = horosphere_areas(triangulation, energy, x);
  std::vector<double> shift(areas.size());
  for (std::size_t v = 0; v < areas.size(); ++v) {
    if (energy.links()[v].kind != VertexKind::kIdeal) continue;
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
  const auto ends_at = [&](std::size_t e, int cusp) {
    const auto corner = triangulation.corners(e)[0];
    const auto ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    return static_cast<double>(std::ranges::count_if(ends, [&](int end) {
      return column[triangulation.vertex_class(corner.tetrahedron(), end)] == cusp;
    }));
  };
  if (cusps == 1) {
    double products = 0, along = 0;
    for (std::size_t e = 0; e < g.size(); ++e) {
      const double ends = ends_at(e, 0);
      products += ends * ends;
      along += ends * g[e];
    }
    for (std::size_t e = 0; e < g.size(); ++e) g[e] -= ends_at(e, 0) * along / products;
    return;
  }
  std::vector<Eigen::Triplet<double>> entries;
  for (std::size_t e = 0; e < g.size(); ++e) {
    const auto corner = triangulation.corners(e)[0];
    for (const int end : topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())])
      if (const int c = column[triangulation.vertex_class(corner.tetrahedron(), end)]; c >= 0)
        entries.emplace_back(static_cast<int>(e), c, 1.0);
  }
  Eigen::SparseMatrix<double> ends(static_cast<Eigen::Index>(g.size()), cusps);
  ends.setFromTriplets(entries.begin(), entries.end());
  const Eigen::SparseMatrix<double> products = ends.transpose() * ends;
  const Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor(products);
  Eigen::Map<Eigen::VectorXd> gradient(g.data(), static_cast<Eigen::Index>(g.size()));
  const Eigen::VectorXd along = factor.solve(ends.transpose() * gradient);
  gradient -= ends * along;
}

}  // namespace tripus::structure
