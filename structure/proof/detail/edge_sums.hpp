#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/proof.hpp"

/// Tetrahedra with hyperideal and ideal vertices in doubles, by geometry/enclosure.hpp: those from
/// number `begin` on, as many as `found` has places. A place is left empty where doubles do not
/// prove the tetrahedron to be a true one, and where `skip` says so.

namespace tripus::structure::detail {

/// A radius made large enough for what a few roundings took from it.
inline double up(double radius) { return radius * (1 + 0x1p-48) + 0x1p-1000; }

/// A sum of enclosures in pairs of doubles: within radius of mid + low. Rounding is to nearest.
struct SumEnclosure {
  double mid = 0, low = 0, radius = 0;
  void add(double m, double r, double l = 0) {
    // The rounding error of mid + m is a double, and this is it.
    const double sum = mid + m, part = sum - mid;
    const double small = ((mid - (sum - part)) + (m - part)) + l;
    mid = sum;
    low += small;
    radius = up(radius + r + (std::fabs(small) + std::fabs(low)) * 0x1p-51);
  }
  void add(const SumEnclosure& other) { add(other.mid, other.radius, other.low); }
  double value() const { return mid + low; }
  /// How far the true sum can be from value().
  double error() const { return up(radius + std::fabs(mid + low) * 0x1p-52); }
  double magnitude() const { return up(std::fabs(value()) + error()); }
};

/// What the tetrahedra around an edge class add up to.
struct EdgeSum {
  SumEnclosure angle;
  double weight = 0;         ///< lower bound of d_e
  std::size_t straight = 0;  ///< corners with angle pi in tetrahedra held flat
};

/// One pass over the tetrahedra in doubles.
struct Pass {
  std::vector<EdgeSum> edges;        // [E]
  SumEnclosure volume;               // of those that are not in `unsound`
  std::vector<std::size_t> unsound;  // tetrahedra that doubles did not prove true over the box
  bool stopped = false;
};

/// Encloses every tetrahedron at the lengths and over the box lengths +- box, but for those that
/// options.flat names.
Pass enclose_all(const topology::Triangulation& triangulation, std::span<const double> lengths,
                 std::span<const double> box, const ProveOptions& options, const Context& context);

/// precise_tetrahedron at the lengths [E]; with volumes not those with both kinds of vertices.
void angles_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                       std::vector<bool> skip, std::size_t begin, bool with_volume,
                       std::span<std::optional<PreciseTetrahedron>> found);
/// precise_jacobian over lengths +- radii [E].
void jacobians_in_doubles(const ConeMetric& metric, std::span<const double> lengths,
                          std::span<const double> radii, const std::vector<bool>& skip,
                          std::size_t begin, std::span<std::optional<std::array<Arb, 21>>> found);

}  // namespace tripus::structure::detail
