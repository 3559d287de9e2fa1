#include <algorithm>
#include <cfenv>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "base/error.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/edge_sums.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/detail/proof_routes.hpp"
#include "structure/proof/proof.hpp"

// The strong-convexity test of docs/theory.md section 9. On the box |x - x0| <= box all tetrahedra
// are shown to be true, and Hess H >= D = diag(d) with d_e the sum of the weights of its corners.
// Then the minimiser exists if the ellipsoid |x - x0|_D <= g, g = |grad H(x0)|_{D^-1}, lies inside
// the box, and it is in that ellipsoid.

namespace tripus::structure {
namespace {

using detail::Arb;
using detail::EdgeSum;
using detail::Pass;
using detail::SumEnclosure;
using detail::up;
using topology::Triangulation;

constexpr int kFirstBits = 128;
constexpr double kFirstBox = 0x1p-30;
constexpr int kAttempts = 6;
constexpr double kPiLow = 0x1.1a62633145c07p-53;

/// Rounding to nearest while it lives: pairs of doubles rest on it.
class NearestRounding {
 public:
  NearestRounding() : before_(std::fegetround()) { std::fesetround(FE_TONEAREST); }
  ~NearestRounding() { std::fesetround(before_); }
  NearestRounding(const NearestRounding&) = delete;
  NearestRounding& operator=(const NearestRounding&) = delete;

 private:
  int before_;
};

/// The work on one triangulation.
struct Attempt {
  const Triangulation& triangulation;
  const detail::ConeMetric& metric;
  const ProveOptions& options;
  const Context& context;
  std::span<const double> lengths;
  Proof proof{};
  bool box_too_large = false;

  std::array<Arb, 6> lengths_of(std::size_t t, bool with_box) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      l[e] = Arb(lengths[edge]);
      if (with_box) l[e] = l[e].widened(proof.box[edge]);
    }
    return l;
  }

  bool refuse(std::string reason) {
    proof.reason = std::move(reason);
    return false;
  }

  /// One tetrahedron in Arb, added to what the others gave.
  bool add_precise(std::size_t t, Pass& pass) {
    for (int bits = kFirstBits; bits <= options.most_bits; bits *= 2) {
      const detail::Precision precision(bits);
      const auto weights = detail::precise_weights(lengths_of(t, true));
      const auto at = detail::precise_tetrahedron(lengths_of(t, false), options.volume);
      if (!weights || !at) {
        // More digits do not help where it is the box that makes the numbers wide.
        if (at && bits > kFirstBits) break;
        continue;
      }
      proof.bits = std::max(proof.bits, bits);
      ++proof.escalated;
      for (std::size_t e = 0; e < 6; ++e) {
        EdgeSum& sum = pass.edges[triangulation.edge_class(t, static_cast<int>(e))];
        add(sum.angle, at->angles[e]);
        sum.weight = (sum.weight + (*weights)[e]) * (1 - 0x1p-48);
      }
      if (options.volume) add(pass.volume, at->volume);
      return true;
    }
    box_too_large = true;
    return refuse(fmt::format(
        "tetrahedron {} is not proved to be a true truncated one near these lengths", t));
  }

  static void add(SumEnclosure& sum, const Arb& term) {
    const double lower = term.lower(), upper = term.upper();
    const double mid = lower + (upper - lower) / 2;
    const Arb rest = term - Arb(mid);
    const double low = rest.mid();
    sum.add(mid, (rest - Arb(low)).magnitude().upper(), low);
  }

  bool add_flat(std::size_t t, Pass& pass) {
    for (int bits = kFirstBits; bits <= options.most_bits; bits *= 2) {
      const detail::Precision precision(bits);
      const auto kind = detail::proved_flat(lengths_of(t, true));
      if (!kind) continue;
      const int pair = *kind == geometry::TetrahedronKind::kFlat01_23   ? 0
                       : *kind == geometry::TetrahedronKind::kFlat02_13 ? 1
                                                                        : 2;
      ++pass.edges[triangulation.edge_class(t, pair)].straight;
      ++pass.edges[triangulation.edge_class(t, 5 - pair)].straight;
      return true;
    }
    box_too_large = true;
    return refuse(fmt::format("tetrahedron {} is not proved to be flat near these lengths", t));
  }

  /// Sets the radii from the sums, and says whether they are inside the box.
  bool find_radii(const Pass& pass) {
    double squares = 0;  // of g
    for (std::size_t e = 0; e < pass.edges.size(); ++e) {
      const EdgeSum& edge = pass.edges[e];
      if (!(edge.weight > 0)) {  // all corners in flat tetrahedra: H does not depend on its length
        if (!metric.cone_angles()[e].is_full() || edge.straight != 2)
          return refuse(fmt::format("the angles pi at edge class {} do not add up to {}", e,
                                    metric.cone_angles()[e].is_full() ? "2 pi" : "its cone angle"));
        continue;
      }
      const double largest = minus_curvature(edge, e).magnitude();
      squares = up(squares + up(up(largest * largest) / edge.weight));
    }
    // An ellipsoid a little larger than g, on whose boundary H grows outwards.
    const double g = up(std::sqrt(squares)) * metric.margin();
    bool inside = std::isfinite(g);
    for (std::size_t e = 0; e < pass.edges.size(); ++e) {
      proof.weights[e] = pass.edges[e].weight;
      proof.radii[e] = proof.weights[e] > 0 ? up(g / root_below(proof.weights[e])) : 0;
      inside = inside && proof.radii[e] < proof.box[e];
    }
    if (!inside) return refuse(not_inside(pass));
    proof.volume = volume_of(pass, squares);
    return true;
  }

  /// The sum of the angles less what is wanted.
  SumEnclosure minus_curvature(const EdgeSum& edge, std::size_t e) const {
    SumEnclosure result = edge.angle;
    const bool full = metric.cone_angles()[e].is_full();
    const double straight = static_cast<double>(edge.straight) - (full ? 2 : 0);
    // pi is the sum of two doubles to within 2^-107.
    result.add(straight * std::numbers::pi, std::fabs(straight) * 0x1p-105, straight * kPiLow);
    if (!full) {
      const detail::Precision precision(kFirstBits);
      add(result, -metric.target(e));
    }
    return result;
  }

  /// A lower bound of the square root.
  static double root_below(double x) { return std::sqrt(x) * (1 - 0x1p-48); }

  std::string not_inside(const Pass& pass) const {
    std::size_t worst = 0;
    double most = 0;
    for (std::size_t e = 0; e < pass.edges.size(); ++e) {
      const double ratio = proof.radii[e] / proof.box[e];
      if (ratio > most || std::isnan(ratio)) {
        most = ratio;
        worst = e;
      }
    }
    return fmt::format(
        "the lengths are not near enough to a minimiser: the bound for edge class {} is {:.3g}, "
        "and "
        "the Hessian is only known within {:.3g}",
        worst, proof.radii[worst], proof.box[worst]);
  }

  /// 2 Vol = H(x*), and H(x0) - H(x*) is in [0, g^2 / 2].
  Interval volume_of(const Pass& pass, double squares) const {
    if (!options.volume || !options.flat.empty()) return {};
    SumEnclosure half_curvature;  // sum of K_e x_e / 2, with K = 2 pi - angles
    for (std::size_t e = 0; e < pass.edges.size(); ++e) {
      const SumEnclosure minus_k = minus_curvature(pass.edges[e], e);
      const double half = lengths[e] / 2, term = minus_k.value() * half;
      half_curvature.add(term, up(minus_k.error() * half + std::fabs(term) * 0x1p-52));
    }
    SumEnclosure volume = pass.volume;
    volume.add(half_curvature);
    const double below = up(volume.error() + squares / 4), above = volume.error();
    return {std::nextafter(volume.value() - below, -std::numeric_limits<double>::infinity()),
            std::nextafter(volume.value() + above, std::numeric_limits<double>::infinity())};
  }

  bool run() {
    proof.bits = 53;
    proof.escalated = 0;
    box_too_large = false;
    Pass pass = detail::enclose_all(triangulation, lengths, proof.box, options, context);
    for (const std::size_t t : options.flat)
      if (!pass.stopped && !add_flat(t, pass)) return false;
    for (std::size_t k = 0; k < pass.unsound.size() && !pass.stopped; ++k) {
      pass.stopped = context.stop_requested() || context.expired();
      if (!pass.stopped && !add_precise(pass.unsound[k], pass)) return false;
    }
    if (pass.stopped) return refuse("stopped before it was decided");
    return find_radii(pass);
  }
};

/// Boxes for the next attempt: smaller where tetrahedra in them were not proved, larger where the
/// radii did not fit. False if that leads nowhere.
bool adjust(const Attempt& attempt, std::span<const double> lengths, std::vector<double>& box) {
  const Proof& proof = attempt.proof;
  for (std::size_t e = 0; e < box.size(); ++e) {
    if (attempt.box_too_large) {
      box[e] = std::max(box[e] * 0x1p-6, lengths[e] * 0x1p-50);
    } else {
      if (!std::isfinite(proof.radii[e])) return false;
      box[e] = std::min(std::max(box[e], 8 * proof.radii[e]), lengths[e] / 4);
    }
  }
  return true;
}

/// Why nothing can be proved of this metric at these lengths, or nothing.
std::string out_of_reach(const detail::ConeMetric& metric, const ProveOptions& options,
                         std::span<const double> lengths) {
  if (!options.flat.empty() && metric.has_finite_vertex())
    return "flat tetrahedra beside finite vertices are not proved";
  if (!options.flat.empty() && std::ranges::any_of(metric.cone_angles(), [](const auto& angle) {
        return angle.is_parabolic();
      }))
    return "flat tetrahedra beside parabolic edges are not proved";
  if (std::string reason = metric.inexact_cusp(); !reason.empty()) return reason;
  for (std::size_t e = 0; e < lengths.size(); ++e) {
    if (!std::isfinite(lengths[e]))
      return fmt::format("the length of edge class {} is not finite", e);
    if (metric.is_fixed(e) && lengths[e] != 0)
      return fmt::format("edge class {} is parabolic: its length is 0, not {}", e, lengths[e]);
    if (!metric.is_fixed(e) && !metric.may_be_negative(e) && !(lengths[e] > 0))
      return fmt::format(
          "the length of edge class {} is {}; between hyperideal vertices it is greater than 0", e,
          lengths[e]);
  }
  return {};
}

}  // namespace

double Proof::largest_radius() const {
  return radii.empty() ? std::numeric_limits<double>::infinity() : *std::ranges::max_element(radii);
}

Proof prove(const Triangulation& triangulation, std::span<const double> lengths,
            const ProveOptions& options, const Context& context) {
  const detail::ConeMetric metric(triangulation, options.cone_angles);
  if (lengths.size() != triangulation.edge_count()) {
    throw InvalidInput(
        fmt::format("{} lengths for {} edge classes", lengths.size(), triangulation.edge_count()));
  }
  Attempt attempt{triangulation, metric, options, context, lengths};
  Proof& proof = attempt.proof;
  proof.claim = options.flat.empty() ? Proof::Claim::kMetric : Proof::Claim::kFlat;
  proof.flat = options.flat;
  if (!topology::all_full(metric.cone_angles())) proof.cone_angles = metric.cone_angles();
  proof.lengths.assign(lengths.begin(), lengths.end());
  proof.radii.resize(lengths.size());
  proof.weights.resize(lengths.size());
  proof.reason = out_of_reach(metric, options, lengths);
  if (!proof.reason.empty()) return std::move(proof);
  for (std::size_t e = 0; e < lengths.size(); ++e)
    proof.box.push_back(kFirstBox * (metric.may_be_negative(e) ? 1.0 : std::min(1.0, lengths[e])));
  const NearestRounding nearest;
  if (metric.has_finite_vertex()) {
    detail::prove_by_interval_newton(metric, options, context, proof);
    return std::move(proof);
  }
  if (!metric.is_strictly_convex()) {
    detail::prove_by_factorisation(metric, options, context, proof);
    return std::move(proof);
  }
  for (int k = 0; k < kAttempts && !proof.proved; ++k) {
    proof.proved = attempt.run();
    if (proof.proved) proof.reason.clear();
    if (context.stop_requested() || context.expired()) break;
    if (!proof.proved && !adjust(attempt, lengths, proof.box)) break;
  }
  if (proof.proved || !options.flat.empty() || context.stop_requested() || context.expired())
    return std::move(proof);
  // Nearly flat tetrahedra are true in very small boxes only; Krawczyk's test gets on with less.
  Proof other = proof;
  other.escalated = 0;
  std::ranges::fill(other.weights, 0.0);
  detail::prove_by_interval_newton(metric, options, context, other);
  if (!other.proved) return std::move(proof);
  other.reason.clear();
  return other;
}

}  // namespace tripus::structure
