#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "embedding/universal_cover.hpp"
#include "orthospectrum/spectrum.hpp"
#include "tests/support/embedded_manifolds.hpp"

/// Orthospectra, and the same by brute force, for the tests of orthospectrum/.
namespace tripus::testing {

inline orthospectrum::Spectrum spectrum_of(const topology::Triangulation& triangulation,
                                           const structure::Report& report, double length,
                                           bool faces = false) {
  orthospectrum::SpectrumOptions options;
  options.length = length;
  options.keep_faces = faces;
  return orthospectrum::orthospectrum(triangulation, report.edge_lengths, options);
}

inline std::vector<double> lengths_of(const orthospectrum::Spectrum& spectrum) {
  std::vector<double> lengths;
  for (const orthospectrum::Arc& arc : spectrum.arcs) lengths.push_back(arc.length);
  return lengths;
}

/// Of the geodesic boundary, without cusps.
inline double boundary_area(const structure::Report& report) {
  double area = 0;
  for (const structure::VertexReport& vertex : report.vertices)
    if (vertex.kind == topology::VertexKind::kHyperideal) area += vertex.area;
  return area;
}

/// The largest difference of two lists of lengths; infinite if one is longer.
inline double difference(const std::vector<double>& first, const std::vector<double>& second) {
  double largest = first.size() == second.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t n = 0; n < std::min(first.size(), second.size()); ++n)
    largest = std::max(largest, std::abs(first[n] - second[n]));
  return largest;
}

/// What every pair of planes says: for each plane near enough to that of a tile the length of the
/// arc, and how much of its foot the tile has: 1, half on a side, a share at a corner.
struct WeightedArc {
  double length = 0, weight = 0;
};

/// From all tiles, by all boundary planes among the cells within `length` of the tile: no
/// unfolding. Oriented arcs, by length. `cells`, if set, receives the largest number of cells.
inline std::vector<WeightedArc> brute_force_arcs(const Embedded& manifold, double length,
                                                 std::size_t* cells = nullptr) {
  using geometry::lorentz_product;
  using geometry::Vector4;
  constexpr double kNear = 1e-7;
  std::vector<WeightedArc> arcs;
  struct Plane {
    Vector4 foot;
    double length;
  };
  for (std::size_t t = 0; t < manifold.embedding.tetrahedra.size(); ++t) {
    const geometry::HyperboloidTetrahedron& root = manifold.embedding.tetrahedra[t];
    double reach = 0;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        if (i != j) reach = std::max(reach, std::acosh(geometry::corner(root, i, j)[3]));
    embedding::UniversalCoverOptions options;
    options.max_radius = length + reach;
    options.root = static_cast<std::uint32_t>(t);
    const auto cover =
        embedding::grow_universal_cover(manifold.embedding, manifold.triangulation, options);
    if (cover.end != embedding::CoverEnd::kComplete) throw std::runtime_error("cover not complete");
    if (cells != nullptr) *cells = std::max(*cells, cover.cells.size());
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector4& v = root.vertices[i];
      std::vector<Plane> planes;
      for (const embedding::Cell& cell : cover.cells) {
        for (const Vector4& pole : manifold.embedding.tetrahedra[cell.tetrahedron].vertices) {
          const Vector4 w = cell.isometry * pole;
          const double cosh = -lorentz_product(v, w);
          if (cosh < 1 + 1e-9 || cosh > std::cosh(length)) continue;
          const Vector4 foot = (w + cosh * v) / std::sqrt((cosh - 1) * (cosh + 1));
          planes.push_back({foot, std::acosh(cosh)});
        }
      }
      std::ranges::sort(planes, {}, [](const Plane& plane) { return plane.foot[0]; });
      for (std::size_t n = 0; n < planes.size(); ++n) {
        bool again = false;
        for (std::size_t m = n; m-- > 0 && planes[n].foot[0] - planes[m].foot[0] < kNear;)
          again = again || (planes[n].foot - planes[m].foot).norm() < kNear;
        if (again) continue;
        int on_sides = 0;
        bool inside = true;
        std::size_t off = 0;  // the face that a foot at a corner is not on
        for (std::size_t f = 0; f < 4; ++f) {
          if (f == i) continue;
          const double over = lorentz_product(planes[n].foot, root.faces[f]);
          inside = inside && over < kNear;
          const bool on = std::abs(over) < kNear;
          on_sides += on;
          if (!on) off = f;
        }
        if (!inside) continue;
        double weight = on_sides == 1 ? 0.5 : 1;
        if (on_sides == 2) {
          weight = 1.0 / static_cast<double>(manifold.triangulation.valence(
                             manifold.triangulation.edge_class(t, topology::kEdgeNumber[i][off])));
        }
        arcs.push_back({planes[n].length, weight});
      }
    }
  }
  std::ranges::sort(arcs, {}, &WeightedArc::length);
  return arcs;
}

/// A length and how many unoriented arcs have it; not whole where the weights are wrong.
struct LengthCount {
  double length = 0, count = 0;
};

/// Lengths that differ by less than 1e-6 are one: brute force is good to some 1e-9.
inline std::vector<LengthCount> counted_by_length(const std::vector<WeightedArc>& arcs) {
  std::vector<LengthCount> counts;
  double last = -1;
  for (const WeightedArc& arc : arcs) {
    if (arc.length - last > 1e-6) counts.push_back({arc.length, 0});
    counts.back().count += arc.weight / 2;
    last = arc.length;
  }
  return counts;
}

inline std::vector<LengthCount> counted_by_length(const orthospectrum::Spectrum& spectrum) {
  std::vector<WeightedArc> arcs;
  for (const orthospectrum::Arc& arc : spectrum.arcs) arcs.push_back({arc.length, 2});
  return counted_by_length(arcs);
}

}  // namespace tripus::testing
