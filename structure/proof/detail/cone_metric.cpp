#include "structure/proof/detail/cone_metric.hpp"

#include <array>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "geometry/edge_frames.hpp"
#include "structure/horospheres.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure::detail {
namespace {

using topology::Triangulation;
using topology::VertexKind;

/// Cusps joined by the edges chosen so far. The numbers of ends of these edges at the cusps are a
/// matrix of full rank as long as no component has more than one odd cycle; a loop is one, and so
/// is an edge that ends elsewhere.
class EvenCycleForest {
 public:
  explicit EvenCycleForest(std::size_t count) : parent_(count), odd_(count), has_odd_cycle_(count) {
    std::iota(parent_.begin(), parent_.end(), std::size_t{0});
  }

  /// Whether the edge raised the rank.
  bool join(std::size_t a, std::size_t b) {
    const auto [root_a, parity_a] = find(a);
    const auto [root_b, parity_b] = find(b);
    if (root_a == root_b) {
      if (has_odd_cycle_[root_a] || parity_a != parity_b) return false;
      return has_odd_cycle_[root_a] = true;
    }
    if (has_odd_cycle_[root_a] && has_odd_cycle_[root_b]) return false;
    parent_[root_a] = root_b;
    odd_[root_a] = parity_a == parity_b;
    has_odd_cycle_[root_b] = has_odd_cycle_[root_a] || has_odd_cycle_[root_b];
    return true;
  }
  bool add_odd_cycle(std::size_t a) { return join(a, a); }

 private:
  struct Place {
    std::size_t root;
    bool parity;
  };
  Place find(std::size_t a) {
    std::size_t root = a;
    bool parity = false;
    for (; parent_[root] != root; root = parent_[root]) parity ^= odd_[root];
    bool rest = parity;
    while (parent_[a] != a) {  // everything on the way hangs from the root now
      const std::size_t next = parent_[a];
      const bool step = odd_[a];
      parent_[a] = root;
      odd_[a] = rest;
      rest ^= step;
      a = next;
    }
    return {root, parity};
  }

  std::vector<std::size_t> parent_;
  std::vector<bool> odd_;  // whether the path to the parent is odd
  std::vector<bool> has_odd_cycle_;
};

}  // namespace

ConeMetric::ConeMetric(const Triangulation& triangulation,
                       std::vector<topology::ConeAngle> cone_angles)
    : triangulation_(triangulation),
      cone_angles_(topology::completed(cone_angles, triangulation.edge_count())),
      any_sign_(triangulation.edge_count()) {
  topology::require_solvable(triangulation, cone_angles_);
  for (const topology::OrbifoldLink& link : topology::orbifold_links(triangulation, cone_angles_)) {
    kinds_.push_back(link.kind);
    finite_vertex_ = finite_vertex_ || link.kind == VertexKind::kFinite;
    strictly_convex_ = strictly_convex_ && link.kind == VertexKind::kHyperideal;
  }
  for (const topology::ConeAngle& angle : cone_angles_)
    strictly_convex_ = strictly_convex_ && !angle.is_parabolic();
  for (std::size_t e = 0; e < any_sign_.size(); ++e) any_sign_[e] = is_any_sign(e);
  pins_ = pins_without(std::vector<bool>(any_sign_.size()));
}

bool ConeMetric::is_any_sign(std::size_t e) const {
  const auto [a, b] = ends(e);
  return is_ideal(a) || is_ideal(b) || is_finite(a) != is_finite(b);
}

std::string ConeMetric::inexact_cusp() const {
  for (std::size_t e = 0; e < cone_angles_.size(); ++e) {
    if (cone_angles_[e].is_rational()) continue;
    for (const std::uint32_t v : ends(e))
      if (is_ideal(v))
        return fmt::format(
            "vertex class {} is a cusp only within rounding, as the cone angle of edge class {} is "
            "no fraction of pi",
            v, e);
  }
  return {};
}

std::vector<std::size_t> ConeMetric::pins_without(const std::vector<bool>& excluded) const {
  std::vector<std::size_t> pins;
  EvenCycleForest forest(kinds_.size());
  for (std::size_t e = 0; e < triangulation_.edge_count(); ++e) {
    const auto [a, b] = ends(e);
    if (excluded[e] || (!is_ideal(a) && !is_ideal(b))) continue;
    const bool raised =
        is_ideal(a) && is_ideal(b) ? forest.join(a, b) : forest.add_odd_cycle(is_ideal(a) ? a : b);
    if (raised) pins.push_back(e);
  }
  return pins;
}

std::array<std::uint32_t, 2> ConeMetric::ends(std::size_t e) const {
  const topology::EdgeCorner corner = triangulation_.corners(e)[0];
  const auto& [a, b] = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
  return {triangulation_.vertex_class(corner.tetrahedron(), a),
          triangulation_.vertex_class(corner.tetrahedron(), b)};
}

Diagonal ConeMetric::diagonal(std::size_t t) const {
  Diagonal diagonal;
  for (int v = 0; v < 4; ++v) {
    const VertexKind kind = kinds_[triangulation_.vertex_class(t, v)];
    diagonal[static_cast<std::size_t>(v)] = kind == VertexKind::kHyperideal ? 1
                                            : kind == VertexKind::kIdeal    ? 0
                                                                            : -1;
  }
  return diagonal;
}

Arb ConeMetric::target(std::size_t e) const {
  const topology::ConeAngle& angle = cone_angles_[e];
  if (!angle.is_rational()) return Arb(angle.radians());
  Arb target = number_pi(Arb());
  arb_mul_si(target.get(), target.get(), angle.numerator(), Precision::bits());
  arb_div_si(target.get(), target.get(), angle.denominator(), Precision::bits());
  return target;
}

namespace {

using geometry::kEdgeBetween;

/// The square of the arc in which the horosphere at vertex i meets the face ijk, theory (80).
Arb arc_squared(const GramEntries& g, const Diagonal& d, int i, int j, int k) {
  const Arb &ij = g.c[kEdgeBetween[i][j]], &ik = g.c[kEdgeBetween[i][k]],
            &jk = g.c[kEdgeBetween[j][k]];
  const auto at = [&](int v) { return static_cast<double>(d[static_cast<std::size_t>(v)]); };
  return at(j) * (Arb(1.0) / square(ij)) + at(k) * (Arb(1.0) / square(ik)) + 2.0 * (jk / (ij * ik));
}

/// The area of the link triangle at an ideal vertex, from its three sides a, b, c (Heron):
/// 16 area^2 = 4 a^2 b^2 - (a^2 + b^2 - c^2)^2.
Arb link_area(const GramEntries& g, const Diagonal& d, int i) {
  const int j = i == 0 ? 1 : 0, k = i <= 1 ? 2 : 1, l = i <= 2 ? 3 : 2;
  const Arb a = arc_squared(g, d, i, j, k), b = arc_squared(g, d, i, k, l);
  const Arb c = arc_squared(g, d, i, j, l);
  return 0.25 * square_root(4.0 * (a * b) - square(a + b - c));
}

}  // namespace

void equalise_horospheres(const ConeMetric& metric, std::vector<Arb>& lengths) {
  const topology::Triangulation& triangulation = metric.triangulation();
  if (metric.pins().empty()) return;
  std::vector<Arb> area(triangulation.vertex_count());
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const Diagonal diagonal = metric.diagonal(t);
    const GramEntries entries = gram_entries(lengths_of(triangulation, lengths, t), diagonal);
    for (int v = 0; v < 4; ++v) {
      if (diagonal[static_cast<std::size_t>(v)] != 0) continue;
      Arb& sum = area[triangulation.vertex_class(t, v)];
      sum = sum + link_area(entries, diagonal, v);
    }
  }
  // Moving a horosphere by s takes e^(-2 s) from its area.
  for (Arb& a : area) {
    if (arb_is_zero(a.get()) != 0) continue;
    a = a / Arb(kHorosphereArea);
    arb_log(a.get(), a.get(), Precision::bits());
    a = 0.5 * a;
  }
  for (std::size_t e = 0; e < lengths.size(); ++e)
    for (const std::size_t v : metric.ends(e)) lengths[e] = lengths[e] + area[v];
}

}  // namespace tripus::structure::detail
