#include <algorithm>
#include <atomic>
#include <cmath>
#include <optional>
#include <span>

#include <fmt/format.h>

#include "base/threads.hpp"
#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/edge_sums.hpp"
#include "structure/proof/detail/positive_definite.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/detail/proof_routes.hpp"

namespace tripus::structure::detail {
namespace {

using geometry::kEdgeFrames;
using geometry::packed_index;

constexpr int kFirstBits = 128;
constexpr int kAttempts = 8;
constexpr std::size_t kChunk = 512;
/// A length at a cusp is measured from a horosphere and may be 0 by chance.
constexpr double kLeastSize = 0x1p-10;

/// An Arb ball in doubles.
struct DoubleBall {
  double mid = 0, radius = 0;
  explicit DoubleBall(const Arb& x) : mid(x.mid()), radius((x - Arb(mid)).magnitude().upper()) {}
};

struct FactorisationProof {
  const ConeMetric& metric;
  const ProveOptions& options;
  const Context& context;
  Proof& proof;
  std::vector<Arb> K{};         // [E] enclosed, at the lengths
  Arb volume{};                 // of the tetrahedra at the lengths
  std::vector<double> scale{};  // [E] the Hessian is looked at as diag(scale) Hess diag(scale)
  std::vector<bool> is_flat{};  // [T] held flat
  std::vector<std::size_t> straight{};  // [E] corners with the angle pi in these
  std::vector<bool> is_out{};  // [E] no unknown: parabolic, or all corners in flat tetrahedra
  std::vector<std::size_t> pins{};
  std::vector<bool> in_precise{};  // [T] what doubles were not enough for
  bool box_too_large = false;

  bool refuse(std::string reason) {
    proof.reason = std::move(reason);
    return false;
  }

  bool stopped() const { return context.stop_requested() || context.expired(); }

  std::array<Arb, 6> lengths_of(std::size_t t, bool with_box) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = metric.triangulation().edge_class(t, static_cast<int>(e));
      l[e] = Arb(proof.lengths[edge]);
      if (with_box && !is_out[edge]) l[e] = l[e].widened(proof.box[edge]);
    }
    return l;
  }

  /// In chunks: what `in_doubles(begin, found)` fills in; `compute(t)`, at 128 bits or, where that
  /// gives nothing, at more, on all threads, for what is left; then `use(t, found)` in order. False
  /// with the reason if a tetrahedron gives nothing.
  template <class InDoubles, class Compute, class Use>
  bool for_each_tetrahedron(InDoubles in_doubles, Compute compute, Use use) {
    using Found = decltype(compute(std::size_t{0}));
    const std::size_t count = metric.triangulation().tetrahedron_count();
    for (std::size_t begin = 0; begin < count; begin += kChunk) {
      if (stopped()) return refuse("stopped before it was decided");
      const std::size_t end = std::min(count, begin + kChunk);
      const Precision precision(kFirstBits);
      std::vector<Found> found(end - begin);
      in_doubles(begin, std::span(found));
      std::vector<std::size_t> left;
      for (std::size_t t = begin; t < end; ++t)
        if (!is_flat[t] && !found[t - begin]) left.push_back(t);
      if (!in_arb(left, begin, compute, found)) return false;
      for (std::size_t t = begin; t < end; ++t)
        if (!is_flat[t]) use(t, *found[t - begin]);
    }
    return true;
  }

  template <class Compute, class Found>
  bool in_arb(const std::vector<std::size_t>& left, std::size_t begin, Compute compute,
              std::vector<Found>& found) {
    const std::size_t threads =
        std::min<std::size_t>(thread_count(context.threads), left.size() / 8 + 1);
    std::vector<int> bits_of(left.size());
    std::atomic<std::size_t> next = 0;
    run_on_threads(threads, [&] {
      for (std::size_t k = next++; k < left.size(); k = next++) {
        int& bits = bits_of[k];
        for (bits = kFirstBits; bits <= options.most_bits && !stopped(); bits *= 2) {
          const Precision precision(bits);
          found[left[k] - begin] = compute(left[k]);
          if (found[left[k] - begin]) break;
        }
      }
    });
    for (std::size_t k = 0; k < left.size(); ++k) {
      if (!found[left[k] - begin]) {
        if (stopped()) return refuse("stopped before it was decided");
        return refuse(fmt::format(
            "tetrahedron {} is not proved to be a true one near these lengths", left[k]));
      }
      proof.bits = std::max(proof.bits, bits_of[k]);
    }
    for (const std::size_t t : left) in_precise[t] = true;
    return true;
  }

  /// What is no unknown, and the pins among the rest.
  bool sort_edges() {
    is_flat.assign(metric.triangulation().tetrahedron_count(), false);
    for (const std::size_t t : options.flat) is_flat[t] = true;
    is_out.assign(proof.lengths.size(), true);
    for (std::size_t t = 0; t < is_flat.size(); ++t)
      for (int e = 0; e < 6 && !is_flat[t]; ++e)
        is_out[metric.triangulation().edge_class(t, e)] = false;
    for (std::size_t e = 0; e < is_out.size(); ++e)
      if (metric.is_fixed(e)) is_out[e] = true;
    pins = options.flat.empty() ? metric.pins() : metric.pins_without(is_out);
    if (pins.size() < metric.pins().size())
      return refuse("with the flat tetrahedra left out no edges hold the horospheres");
    return true;
  }

  /// Shows the flat tetrahedra to be flat over the box, and counts their angles pi.
  bool enclose_flat() {
    straight.assign(proof.lengths.size(), 0);
    for (const std::size_t t : options.flat) {
      std::optional<geometry::TetrahedronKind> kind;
      for (int bits = kFirstBits; bits <= options.most_bits && !kind; bits *= 2) {
        const Precision precision(bits);
        kind = proved_flat(lengths_of(t, true), metric.diagonal(t));
      }
      if (!kind) {
        box_too_large = true;
        return refuse(fmt::format("tetrahedron {} is not proved to be flat near these lengths", t));
      }
      const int pair = *kind == geometry::TetrahedronKind::kFlat01_23   ? 0
                       : *kind == geometry::TetrahedronKind::kFlat02_13 ? 1
                                                                        : 2;
      ++straight[metric.triangulation().edge_class(t, pair)];
      ++straight[metric.triangulation().edge_class(t, 5 - pair)];
    }
    for (std::size_t e = 0; e < is_out.size(); ++e)
      if (is_out[e] && !metric.is_fixed(e) &&
          (straight[e] != 2 || !metric.cone_angles()[e].is_full()))
        return refuse(
            fmt::format("the angles pi at edge class {} do not add up to what is wanted", e));
    return true;
  }

  /// The curvature with the angles of the flat tetrahedra.
  Arb curvature(std::size_t e) const {
    if (straight[e] == 0) return K[e];
    return K[e] - static_cast<double>(straight[e]) * number_pi(K[e]);
  }

  /// Curvatures and volume at the lengths themselves, but for the flat tetrahedra.
  bool enclose_lengths() {
    const Precision precision(kFirstBits);
    for (std::size_t e = 0; e < proof.lengths.size(); ++e) K.push_back(metric.target(e));
    return for_each_tetrahedron(
        [&](std::size_t begin, std::span<std::optional<PreciseTetrahedron>> found) {
          angles_in_doubles(metric, proof.lengths, is_flat, begin, options.volume, found);
        },
        [&](std::size_t t) {
          return precise_tetrahedron(lengths_of(t, false), options.volume, metric.diagonal(t));
        },
        [&](std::size_t t, const PreciseTetrahedron& found) {
          for (int e = 0; e < 6; ++e) {
            Arb& sum = K[metric.triangulation().edge_class(t, e)];
            sum = sum - found.angles[static_cast<std::size_t>(e)];
          }
          if (options.volume) volume = volume + found.volume;
        });
  }

  /// The most terms that an entry of the Hessian is a sum of.
  double most_terms() const {
    std::size_t most = 0;
    for (std::size_t e = 0; e < proof.lengths.size(); ++e)
      most = std::max(most, metric.triangulation().valence(e));
    return 6 * static_cast<double>(most) + 2;
  }

  /// The Hessian over the box, scaled to a diagonal near 1 and with the pins held.
  std::optional<EnclosedMatrix> scaled_hessian() {
    using Triplet = Eigen::Triplet<double>;
    const int n = static_cast<int>(proof.lengths.size());
    std::vector<Triplet> mids, radii;
    std::vector<double> diagonal(proof.lengths.size());
    const double rounding = most_terms() * 0x1p-52;
    const auto add = [&](std::size_t i, std::size_t j, double mid, double radius) {
      const auto row = static_cast<int>(std::max(i, j)), column = static_cast<int>(std::min(i, j));
      mids.emplace_back(row, column, mid);
      radii.emplace_back(row, column, up(radius + std::fabs(mid) * rounding));
    };
    std::vector<double> box = proof.box;
    for (std::size_t e = 0; e < box.size(); ++e)
      if (is_out[e]) box[e] = 0;
    const bool all_true = for_each_tetrahedron(
        [&](std::size_t begin, std::span<std::optional<std::array<Arb, 21>>> found) {
          jacobians_in_doubles(metric, proof.lengths, box, is_flat, begin, found);
        },
        [&](std::size_t t) { return precise_jacobian(lengths_of(t, true), metric.diagonal(t)); },
        [&](std::size_t t, const std::array<Arb, 21>& jacobian) {
          for (int i = 0; i < 6; ++i)
            for (int j = i; j < 6; ++j) {
              const std::size_t a = metric.triangulation().edge_class(t, i);
              const std::size_t b = metric.triangulation().edge_class(t, j);
              if (is_out[a] || is_out[b]) continue;
              const DoubleBall entry(jacobian[static_cast<std::size_t>(packed_index(i, j))]);
              // Two edges of a tetrahedron in one class give their entry twice.
              const double times = a == b && i != j ? 2 : 1;
              add(a, b, times * entry.mid, times * entry.radius);
              if (i == j) diagonal[a] += entry.mid;
            }
        });
    if (!all_true) {
      box_too_large = true;
      return std::nullopt;
    }
    for (std::size_t e = 0; e < diagonal.size(); ++e) {
      if (is_out[e]) {
        scale[e] = 1;
        add(e, e, 1, 0);
      } else if (!(diagonal[e] > 0) || !std::isfinite(diagonal[e])) {
        box_too_large = true;
        refuse(fmt::format("the Hessian is not positive at edge class {}", e));
        return std::nullopt;
      } else {
        scale[e] = 1 / std::sqrt(diagonal[e]);
      }
    }
    for (const std::size_t e : pins) add(e, e, diagonal[e], 0);
    EnclosedMatrix matrix{Eigen::SparseMatrix<double>(n, n), Eigen::SparseMatrix<double>(n, n)};
    matrix.mid.setFromTriplets(mids.begin(), mids.end());
    matrix.radius.setFromTriplets(radii.begin(), radii.end());
    scale_entries(matrix);
    return matrix;
  }

  void scale_entries(EnclosedMatrix& matrix) const {
    for (int j = 0; j < matrix.mid.outerSize(); ++j) {
      Eigen::SparseMatrix<double>::InnerIterator mid(matrix.mid, j), radius(matrix.radius, j);
      for (; mid; ++mid, ++radius) {
        const double s = scale[static_cast<std::size_t>(mid.row())];
        const double r = scale[static_cast<std::size_t>(j)];
        mid.valueRef() = s * mid.value() * r;
        radius.valueRef() = up(up(s * radius.value()) * r + std::fabs(mid.value()) * 0x1p-51);
      }
    }
  }

  /// Sets weights and radii, and says whether the radii are inside the box.
  bool find_radii(double least) {
    const Precision precision(kFirstBits);
    double squares = 0;
    for (std::size_t e = 0; e < K.size(); ++e) {
      if (is_out[e]) continue;
      proof.weights[e] = least / scale[e] / scale[e] * (1 - 0x1p-48);
      const double largest = curvature(e).magnitude().upper();
      squares = up(squares + up(up(largest * largest) / proof.weights[e]));
    }
    const double g = up(std::sqrt(squares)) * metric.margin();
    bool inside = std::isfinite(g);
    for (std::size_t e = 0; e < K.size(); ++e) {
      if (is_out[e]) continue;
      proof.radii[e] = up(g / (std::sqrt(proof.weights[e]) * (1 - 0x1p-48)));
      inside = inside && proof.radii[e] < proof.box[e];
    }
    if (!inside) return refuse(not_inside());
    if (options.volume && options.flat.empty()) set_volume(squares);
    return true;
  }

  std::string not_inside() const {
    std::size_t worst = 0;
    for (std::size_t e = 0; e < K.size(); ++e)
      if (!(proof.radii[e] <= proof.radii[worst])) worst = e;
    return fmt::format(
        "the lengths are not near enough to a minimiser: the bound for edge class {} is {:.3g}, "
        "and the Hessian is only known within {:.3g}",
        worst, proof.radii[worst], proof.box[worst]);
  }

  /// Theory (96).
  void set_volume(double squares) {
    const Precision precision(kFirstBits);
    Arb sum = volume;
    for (std::size_t e = 0; e < K.size(); ++e) sum = sum - 0.5 * (K[e] * Arb(proof.lengths[e]));
    const Arb eighth = Arb(up(squares / 8));
    sum = (sum - eighth).widened_by(eighth);
    proof.volume = {sum.lower(), sum.upper()};
  }

  bool try_box() {
    box_too_large = false;
    if (!enclose_flat()) return false;
    const auto matrix = scaled_hessian();
    if (!matrix) return false;
    const double least = least_eigenvalue_bound(*matrix);
    if (!(least > 0)) {
      box_too_large = true;
      return refuse("the Hessian is not proved to be positive definite near these lengths");
    }
    return find_radii(least);
  }

  /// As in prove.cpp. False where no other box helps.
  bool adjust() {
    for (std::size_t e = 0; e < proof.box.size(); ++e) {
      // Between hyperideal vertices the box must stay at positive lengths.
      const double size = metric.may_be_negative(e)
                              ? std::max(std::fabs(proof.lengths[e]), kLeastSize)
                              : proof.lengths[e];
      if (box_too_large) {
        if (proof.box[e] <= size * 0x1p-50) return false;
        proof.box[e] = std::max(proof.box[e] * 0x1p-6, size * 0x1p-50);
      } else {
        if (!std::isfinite(proof.radii[e])) return false;
        proof.box[e] = std::max(proof.box[e], 8 * proof.radii[e]);
        if (!metric.may_be_negative(e)) proof.box[e] = std::min(proof.box[e], size / 4);
      }
    }
    return true;
  }

  void run() {
    scale.resize(proof.lengths.size());
    in_precise.resize(metric.triangulation().tetrahedron_count());
    if (!sort_edges() || !enclose_lengths()) return;
    for (int k = 0; k < kAttempts && !proof.proved; ++k) {
      proof.proved = try_box();
      if (proof.proved) proof.reason.clear();
      if (stopped() || (!proof.proved && !adjust())) break;
    }
    proof.escalated = static_cast<std::size_t>(std::ranges::count(in_precise, true));
  }
};

}  // namespace

void prove_by_factorisation(const ConeMetric& metric, const ProveOptions& options,
                            const Context& context, Proof& proof) {
  FactorisationProof{metric, options, context, proof}.run();
}

}  // namespace tripus::structure::detail
