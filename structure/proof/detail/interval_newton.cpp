#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/finite_links.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/detail/proof_routes.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::packed_index;

constexpr int kBits = 192;
constexpr double kFirstRadius = 0x1p-34;
/// Nothing less is claimed: other code should be able to follow with fewer bits.
constexpr double kLeastRadius = 0x1p-60;
/// A column of the matrix of gauges is no pivot below this share of the largest entry.
constexpr double kLeastPivot = 1e-6;
constexpr std::size_t kMostEdges = 400;

/// An equation that the curvatures of all edges satisfy up to a square: |sum of coefficient K| <=
/// square (sum of |K| over the ends at the vertex)^2. At cusps `square` is 0.
struct Gauge {
  std::vector<Arb> coefficient;  // [E]
  std::size_t vertex = 0;
  Arb square;
  std::vector<int> ends;  // [E] at the vertex
};

struct IntervalNewton {
  const ConeMetric& metric;
  const ProveOptions& options;
  const Context& context;
  Proof& proof;
  std::vector<bool> held{};           // [E] their lengths stay, their equations are left out
  std::vector<std::size_t> chosen{};  // the others
  std::vector<Arb> x{};               // [E] exact
  std::vector<Arb> box{};             // [E] around x: where the metric is

  const topology::Triangulation& triangulation() const { return metric.triangulation(); }

  bool refuse(std::string reason) {
    proof.reason = std::move(reason);
    return false;
  }
  bool stopped() {
    if (!context.stop_requested() && !context.expired()) return false;
    proof.reason = "stopped before it was decided";
    return true;
  }

  struct Angles {
    std::vector<std::array<Arb, 6>> of;  // [T]
    std::vector<Arb> K;                  // [E]
    Arb volume;
  };
  std::optional<Angles> angles_at(const std::vector<Arb>& lengths, bool with_volume) {
    Angles result;
    for (std::size_t e = 0; e < x.size(); ++e) result.K.push_back(metric.target(e));
    for (std::size_t t = 0; t < triangulation().tetrahedron_count(); ++t) {
      if (stopped()) return std::nullopt;
      auto found = precise_tetrahedron(detail::lengths_of(triangulation(), lengths, t), with_volume,
                                       metric.diagonal(t));
      if (!found) {
        refuse(fmt::format("tetrahedron {} is not proved to be a true one near these lengths", t));
        return std::nullopt;
      }
      for (std::size_t e = 0; e < 6; ++e) {
        Arb& sum = result.K[triangulation().edge_class(t, static_cast<int>(e))];
        sum = sum - found->angles[e];
      }
      if (with_volume) result.volume = result.volume + found->volume;
      result.of.push_back(std::move(found->angles));
    }
    return result;
  }

  // ---- which equations are left out -------------------------------------------------------------

  /// The equations at all finite vertices and cusps.
  std::optional<std::vector<Gauge>> gauges(const Angles& angles) {
    std::vector<Gauge> result;
    for (std::size_t v = 0; v < triangulation().vertex_count(); ++v) {
      if (metric.is_ideal(v)) {
        Gauge gauge = empty_gauge(v);
        for (std::size_t e = 0; e < x.size(); ++e)
          for (const std::size_t end : metric.ends(e))
            if (end == v) gauge.coefficient[e] = gauge.coefficient[e] + Arb(1.0);
        result.push_back(std::move(gauge));
      } else if (metric.is_finite(v) && !add_finite(v, angles, result)) {
        return std::nullopt;
      }
    }
    return result;
  }

  Gauge empty_gauge(std::size_t v) const {
    Gauge gauge;
    gauge.vertex = v;
    gauge.coefficient.resize(x.size());
    gauge.ends.resize(x.size());
    return gauge;
  }

  bool add_finite(std::size_t v, const Angles& angles, std::vector<Gauge>& gauges) {
    const auto ends = unfolded_link(triangulation(), v, angles.of);
    if (!ends) return refuse(fmt::format("the link of vertex class {} is not unfolded", v));
    std::vector<const EdgeEnd*> singular;
    for (const EdgeEnd& end : *ends)
      if (!metric.cone_angles()[end.edge].is_full()) singular.push_back(&end);
    if (singular.size() > 2) return true;  // the vertex cannot move
    if (singular.size() == 1)
      return refuse(fmt::format("vertex class {} has one singular edge end", v));
    for (std::size_t i = 0; i < (singular.empty() ? 3u : 1u); ++i) {
      Gauge gauge = empty_gauge(v);
      for (const EdgeEnd& end : *ends) {
        Arb& sum = gauge.coefficient[end.edge];
        sum = sum +
              (singular.empty() ? end.direction[i] : dot(end.direction, singular[0]->direction));
        ++gauge.ends[end.edge];
      }
      gauge.square = Arb(0.5);
      if (!singular.empty() && !find_square(*singular[0], *singular[1], angles, *ends, gauge))
        return false;
      gauges.push_back(std::move(gauge));
    }
    return true;
  }

  /// At a vertex on a singular edge: by how much the rotations about its two directions can be off.
  bool find_square(const EdgeEnd& a, const EdgeEnd& b, const Angles& angles,
                   const std::vector<EdgeEnd>& ends, Gauge& gauge) {
    const Arb sum[3] = {a.direction[0] + b.direction[0], a.direction[1] + b.direction[1],
                        a.direction[2] + b.direction[2]};
    if (!held.empty() && (held[a.edge] || held[b.edge]))
      return refuse(fmt::format("the singular edge at vertex class {} is held", gauge.vertex));
    // The angle between a and -b is at most pi/2 times its chord.
    const Arb chord = square_root((square(sum[0]) + square(sum[1]) + square(sum[2])).upper_end());
    const Arb bend = 0.5 * (number_pi(Arb()) * chord);
    Arb turn;
    for (const EdgeEnd& end : ends)
      if (metric.cone_angles()[end.edge].is_full()) turn = turn + angles.K[end.edge].magnitude();
    const Arb off = 0.5 * turn + bend;
    Arb half = 0.5 * metric.target(a.edge);
    arb_sin(half.get(), half.get(), Precision::bits());
    arb_abs(half.get(), half.get());
    const Arb rest = half - off;
    if (!rest.positive())
      return refuse(fmt::format("the singular edge at vertex class {} is not proved to be straight",
                                gauge.vertex));
    const Arb share = (Arb(1.0) + off) / rest;
    gauge.square = (0.5 * square(Arb(1.0) + share)).upper_end();
    return true;
  }

  /// The row and edge of the largest entry that may be one; any other if there is none.
  std::pair<std::size_t, std::size_t> pivot(const std::vector<std::vector<double>>& rows,
                                            const std::vector<bool>& done, bool full_only) const {
    std::pair<std::size_t, std::size_t> best{0, 0};
    double most = -1;
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (std::size_t e = 0; !done[r] && e < x.size(); ++e) {
        const topology::ConeAngle& angle = metric.cone_angles()[e];
        if (held[e] || angle.is_parabolic() || (full_only && !angle.is_full())) continue;
        if (!(std::fabs(rows[r][e]) > most)) continue;
        most = std::fabs(rows[r][e]);
        best = {r, e};
      }
    return best;
  }

  /// Holds an edge for each gauge: those with the largest pivots.
  bool choose(const std::vector<Gauge>& gauges) {
    held.assign(x.size(), false);
    std::vector<std::vector<double>> rows;
    double largest = 0;
    for (const Gauge& gauge : gauges) {
      auto& row = rows.emplace_back();
      for (const Arb& c : gauge.coefficient) {
        row.push_back(c.mid());
        largest = std::max(largest, std::fabs(row.back()));
      }
    }
    std::vector<bool> done(rows.size());
    for (std::size_t k = 0; k < rows.size(); ++k) {
      // Singular edges only where there are no others, as at cusps.
      auto [row, edge] = pivot(rows, done, true);
      if (!(std::fabs(rows[row][edge]) > kLeastPivot * largest))
        std::tie(row, edge) = pivot(rows, done, false);
      if (!(std::fabs(rows[row][edge]) > kLeastPivot * largest))
        return refuse("no edges are found that hold the finite vertices in place");
      held[edge] = done[row] = true;
      for (std::size_t r = 0; r < rows.size(); ++r) {
        if (done[r]) continue;
        const double factor = rows[r][edge] / rows[row][edge];
        for (std::size_t e = 0; e < x.size(); ++e) rows[r][e] -= factor * rows[row][e];
      }
    }
    chosen.clear();
    for (std::size_t e = 0; e < x.size(); ++e)
      if (!held[e] && !metric.is_fixed(e)) chosen.push_back(e);
    return true;
  }

  // ---- Krawczyk's test --------------------------------------------------------------------------

  std::vector<Arb> widened(const std::vector<Arb>& radius) const {
    std::vector<Arb> result = x;
    for (const std::size_t e : chosen) result[e] = result[e].widened_by(radius[e]);
    return result;
  }

  /// The Jacobian of the chosen angle sums over lengths.
  bool jacobian(const std::vector<Arb>& lengths, ArbMatrix& J) {
    std::vector<std::size_t> row(x.size(), chosen.size());
    for (std::size_t k = 0; k < chosen.size(); ++k) row[chosen[k]] = k;
    for (std::size_t t = 0; t < triangulation().tetrahedron_count(); ++t) {
      if (stopped()) return false;
      const auto found =
          precise_jacobian(detail::lengths_of(triangulation(), lengths, t), metric.diagonal(t));
      if (!found)
        return refuse(
            fmt::format("tetrahedron {} is not proved to be a true one near these lengths", t));
      for (int i = 0; i < 6; ++i)
        for (int j = 0; j < 6; ++j) {
          const std::size_t a = row[triangulation().edge_class(t, i)];
          const std::size_t b = row[triangulation().edge_class(t, j)];
          if (a == chosen.size() || b == chosen.size()) continue;
          arb_add(J.at(a, b), J.at(a, b),
                  (*found)[static_cast<std::size_t>(packed_index(std::min(i, j), std::max(i, j)))]
                      .get(),
                  Precision::bits());
        }
    }
    return true;
  }

  /// Shows that the chosen equations have a solution in the box of these radii, the only one there;
  /// then sets `box` to a smaller one.
  bool krawczyk(const std::vector<Arb>& K, const std::vector<Arb>& radius) {
    const std::size_t n = chosen.size();
    ArbMatrix J(n, n), inverse(n, n), rest(n, n), residual(n, 1), step(n, 1);
    if (!jacobian(widened(radius), J)) return false;
    ArbMatrix middle(n, n);
    arb_mat_get_mid(middle.get(), J.get());
    if (n > 0 && arb_mat_approx_inv(inverse.get(), middle.get(), Precision::bits()) == 0)
      return refuse("the equations are singular near these lengths");
    arb_mat_get_mid(inverse.get(), inverse.get());
    arb_mat_mul(rest.get(), inverse.get(), J.get(), Precision::bits());
    for (std::size_t k = 0; k < n; ++k) {
      arb_sub_si(rest.at(k, k), rest.at(k, k), 1, Precision::bits());
      arb_set(residual.at(k, 0), K[chosen[k]].get());
    }
    arb_mat_mul(step.get(), inverse.get(), residual.get(), Precision::bits());
    box.assign(x.size(), Arb());
    for (std::size_t i = 0; i < n; ++i) {
      Arb reach;
      arb_abs(reach.get(), step.at(i, 0));
      for (std::size_t j = 0; j < n; ++j) {
        Arb entry;
        arb_abs(entry.get(), rest.at(i, j));
        reach = reach + entry.upper_end() * radius[chosen[j]];
      }
      box[chosen[i]] = reach.upper_end();
      if (!(radius[chosen[i]] - box[chosen[i]]).positive())
        return refuse(
            fmt::format("the lengths are not near enough to a solution: the step at edge class {} "
                        "is {:.3g}, and the Jacobian is only known within {:.3g}",
                        chosen[i], box[chosen[i]].upper(), radius[chosen[i]].upper()));
    }
    return true;
  }

  // ---- the equations that were left out ---------------------------------------------------------

  /// The curvatures of the held edges are so small that they must be 0.
  bool rest_vanishes(const Angles& angles) {
    const auto found = gauges(angles);
    if (!found) return false;
    std::vector<std::size_t> left;
    for (std::size_t e = 0; e < x.size(); ++e)
      if (held[e]) left.push_back(e);
    const std::size_t n = left.size();
    if (n == 0) return true;
    ArbMatrix M(n, n), inverse(n, n);
    Arb square_most, largest;
    for (std::size_t r = 0; r < n; ++r) {
      int ends = 0;
      for (std::size_t k = 0; k < n; ++k) {
        arb_set(M.at(r, k), (*found)[r].coefficient[left[k]].get());
        ends += (*found)[r].ends[left[k]];
      }
      const Arb most =
          (static_cast<double>(ends) * (static_cast<double>(ends) * (*found)[r].square))
              .upper_end();
      if (larger(most, square_most)) square_most = most;
    }
    for (const std::size_t e : left) {
      const Arb size = angles.K[e].magnitude();
      if (larger(size, largest)) largest = size;
    }
    if (arb_mat_inv(inverse.get(), M.get(), Precision::bits()) == 0)
      return refuse("the held edges are not proved to hold the finite vertices in place");
    Arb norm;
    for (std::size_t i = 0; i < n; ++i) {
      Arb sum;
      for (std::size_t j = 0; j < n; ++j) {
        Arb entry;
        arb_abs(entry.get(), inverse.at(i, j));
        sum = sum + entry.upper_end();
      }
      sum = sum.upper_end();
      if (larger(sum, norm)) norm = sum;
    }
    if (!(Arb(1.0) - norm * (square_most * largest)).positive())
      return refuse(
          fmt::format("the curvatures of the held edges, up to {:.3g}, are not proved to vanish",
                      largest.upper()));
    return true;
  }

  /// By Schlaefli's formula dV = sum x_e dK_e / 2, integrated by parts from x, where K is known, to
  /// the metric, where it is 0.
  void set_volume(const Angles& at, const Angles& around) {
    Arb volume = at.volume, off;
    for (std::size_t e = 0; e < x.size(); ++e) {
      volume = volume - 0.5 * (at.K[e] * x[e]);
      off = off + 0.5 * (around.K[e].magnitude() * box[e]);
    }
    volume = volume.widened_by(off);
    proof.volume = {volume.lower(), volume.upper()};
  }

  bool run() {
    const Precision precision(kBits);
    proof.bits = kBits;
    if (proof.lengths.size() > kMostEdges)
      return refuse(fmt::format("with finite vertices there are proofs for up to {} edge classes",
                                kMostEdges));
    for (const double l : proof.lengths) x.emplace_back(l);
    const auto at = angles_at(x, options.volume);
    if (!at) return false;
    const auto first = gauges(*at);
    if (!first || !choose(*first)) return false;
    if (!krawczyk(at->K, std::vector<Arb>(x.size(), Arb(kFirstRadius)))) return false;
    // Once more in a box that is twice what was found: the Jacobian hardly varies there.
    std::vector<Arb> radius = box;
    for (Arb& r : radius) r = (2.0 * r + Arb(0x1p-150)).upper_end();
    if (!krawczyk(at->K, radius)) return false;
    for (const std::size_t e : chosen) {
      box[e] = (metric.margin() * box[e]).upper_end();
      if (!larger(box[e], Arb(kLeastRadius))) box[e] = Arb(kLeastRadius);
    }
    auto around = angles_at(widened(box), false);
    if (!around) return false;
    if (options.volume) set_volume(*at, *around);
    // The equations that were shown hold exactly.
    for (const std::size_t e : chosen) around->K[e] = Arb();
    if (!rest_vanishes(*around)) return false;
    for (std::size_t e = 0; e < x.size(); ++e) proof.box[e] = proof.radii[e] = box[e].upper();
    return true;
  }
};

}  // namespace

void prove_by_interval_newton(const ConeMetric& metric, const ProveOptions& options,
                              const Context& context, Proof& proof) {
  proof.proved = IntervalNewton{metric, options, context, proof}.run();
}

}  // namespace tripus::structure::detail
