#include "structure/proof/digits.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

#include "base/error.hpp"
#include "geometry/edge_frames.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/cone_metric.hpp"
#include "structure/proof/detail/precise_tetrahedron.hpp"
#include "structure/proof/proof_text.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using detail::ArbMatrix;
using detail::Precision;
using topology::Triangulation;

constexpr int kMostDigits = 100000;
constexpr double kBitsOfDigit = 3.32192809488736235;
/// Bits beyond the digits: for the condition of the problem, and again if they were too few.
constexpr long kGuardBits = 96;
constexpr int kTries = 4;
constexpr int kExtraDigits = 12;

struct DigitsRun {
  const Triangulation& triangulation;
  const Proof& proof;
  const Context& context;
  detail::ConeMetric metric{triangulation, proof.cone_angles};
  std::vector<Arb> x{};  // [E] exact
  Digits result{};

  static auto angles(const std::array<Arb, 6>& l, const detail::Diagonal& diagonal) {
    return detail::precise_tetrahedron(l, false, diagonal);
  }
  static auto angles_and_volume(const std::array<Arb, 6>& l, const detail::Diagonal& diagonal) {
    return detail::precise_tetrahedron(l, true, diagonal);
  }
  static auto jacobian(const std::array<Arb, 6>& l, const detail::Diagonal& diagonal) {
    return detail::precise_jacobian(l, diagonal);
  }

  /// Lengths that Newton's method leaves: parabolic edges, and one at each cusp.
  std::vector<std::size_t> held() const {
    std::vector<std::size_t> held = metric.pins();
    for (std::size_t e = 0; e < x.size(); ++e)
      if (metric.is_fixed(e)) held.push_back(e);
    return held;
  }

  bool stopped() {
    if (!context.stop_requested() && !context.expired()) return false;
    result.reason = "stopped before it was decided";
    return true;
  }

  std::array<Arb, 6> lengths_of(std::size_t t) const {
    return detail::lengths_of(triangulation, x, t);
  }

  /// What `compute(lengths, diagonal)` gives for every tetrahedron; those with the same edge
  /// classes in the same order share it.
  template <class Compute, class Use>
  bool for_each_tetrahedron(Compute compute, Use use) {
    std::map<std::array<std::uint32_t, 6>, decltype(compute(lengths_of(0), metric.diagonal(0)))>
        known;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      if (stopped()) return false;
      std::array<std::uint32_t, 6> key;
      for (std::size_t e = 0; e < 6; ++e) key[e] = triangulation.edge_class(t, static_cast<int>(e));
      auto found = known.find(key);
      if (found == known.end())
        found = known.emplace(key, compute(lengths_of(t), metric.diagonal(t))).first;
      if (!found->second) {
        result.reason = fmt::format("tetrahedron {} could not be enclosed", t);
        return false;
      }
      use(t, *found->second);
    }
    return true;
  }

  std::vector<Arb> curvature_start() const {
    std::vector<Arb> K;
    for (std::size_t e = 0; e < x.size(); ++e) K.push_back(metric.target(e));
    return K;
  }

  /// One step of Newton's method at the thread's precision.
  bool newton_step() {
    const std::size_t n = x.size();
    ArbMatrix hessian(n, n), curvature(n, 1), step(n, 1);
    std::vector<Arb> K = curvature_start();
    const bool enclosed =
        for_each_tetrahedron(angles,
                             [&](std::size_t t, const auto& found) {
                               for (std::size_t i = 0; i < 6; ++i) {
                                 Arb& sum = K[triangulation.edge_class(t, static_cast<int>(i))];
                                 sum = sum - found.angles[i];
                               }
                             }) &&
        for_each_tetrahedron(jacobian, [&](std::size_t t, const auto& found) {
          for (int i = 0; i < 6; ++i)
            for (int j = 0; j < 6; ++j) {
              const auto q =
                  static_cast<std::size_t>(geometry::packed_index(std::min(i, j), std::max(i, j)));
              arb_ptr entry =
                  hessian.at(triangulation.edge_class(t, i), triangulation.edge_class(t, j));
              arb_add(entry, entry, found[q].get(), Precision::bits());
            }
        });
    if (!enclosed) return false;
    for (std::size_t e = 0; e < n; ++e) arb_set(curvature.at(e, 0), K[e].get());
    for (const std::size_t e : held()) {
      for (std::size_t i = 0; i < n; ++i) {
        arb_zero(hessian.at(i, e));
        arb_zero(hessian.at(e, i));
      }
      arb_one(hessian.at(e, e));
      arb_zero(curvature.at(e, 0));
    }
    if (arb_mat_approx_solve(step.get(), hessian.get(), curvature.get(), Precision::bits()) == 0) {
      result.reason = "the Hessian is singular in approximate arithmetic";
      return false;
    }
    for (std::size_t e = 0; e < n; ++e) {
      arb_add(x[e].get(), x[e].get(), step.at(e, 0), Precision::bits());
      x[e] = x[e].midpoint();
    }
    return true;
  }

  /// Newton's method doubles the correct bits, so the precision follows.
  bool refine(long bits) {
    x.clear();
    for (const double l : proof.lengths) x.emplace_back(l);
    std::vector<long> ladder{bits};
    while (ladder.back() > 100) ladder.push_back(ladder.back() / 2 + 32);
    for (auto step = ladder.rbegin(); step != ladder.rend(); ++step) {
      const Precision precision(*step + 32);
      if (!newton_step()) return false;
    }
    return true;
  }

  /// Theory (97) at x; the radii [E], and behind them that of the volume. Sets the volume.
  bool certify(int digits, std::vector<Arb>& radii) {
    std::vector<Arb> K = curvature_start();
    Arb volume;
    if (!for_each_tetrahedron(angles_and_volume, [&](std::size_t t, const auto& found) {
          volume = volume + found.volume;
          for (std::size_t i = 0; i < 6; ++i) {
            Arb& sum = K[triangulation.edge_class(t, static_cast<int>(i))];
            sum = sum - found.angles[i];
          }
        }))
      return false;
    Arb squares;
    for (std::size_t e = 0; e < x.size(); ++e) {
      if (metric.is_fixed(e)) continue;
      squares = squares + square(K[e]) / Arb(proof.weights[e]);
      volume = volume - 0.5 * (K[e] * x[e]);
    }
    const Arb g = metric.margin() * square_root(squares.upper_end());
    for (std::size_t e = 0; e < x.size(); ++e) {
      if (metric.is_fixed(e)) {
        radii.emplace_back();
        continue;
      }
      radii.push_back((g / square_root(Arb(proof.weights[e]))).upper_end());
      const Arb reach = radii[e] + (x[e] - Arb(proof.lengths[e])).magnitude();
      if (!(Arb(proof.box[e]) - reach).positive()) {
        result.reason = fmt::format("edge class {} leaves the box of the proof in doubles", e);
        return false;
      }
    }
    // The volume is lower than at x by at most g^2 / 4.
    const Arb eighth = 0.125 * squares.upper_end();
    volume = (volume - eighth).widened_by(eighth);
    result.volume = {decimal_below(volume, digits), decimal_above(volume, digits)};
    radii.push_back((volume - volume.midpoint()).magnitude());
    return true;
  }

  /// Lengths get some more digits than what follows from them, so that the angles of the lengths as
  /// they are written are known to all the digits wanted. All else is about the lengths as written.
  void write_lengths(int places) {
    result.lengths.clear();
    for (Arb& length : x) {
      result.lengths.push_back(detail::decimal_near(length, places));
      length = detail::from_decimal(result.lengths.back());
    }
  }

  void write_rest(int digits, const std::vector<Arb>& radii) {
    for (std::size_t e = 0; e < x.size(); ++e) {
      result.radii.push_back(detail::decimal_radius(radii[e], digits + kExtraDigits + 2));
      x[e] = x[e].widened_by(detail::from_decimal(result.radii[e]));
    }
    result.dihedral_angles.resize(triangulation.tetrahedron_count());
    for_each_tetrahedron(angles, [&](std::size_t t, const auto& found) {
      for (std::size_t i = 0; i < 6; ++i)
        result.dihedral_angles[t][i] = {detail::decimal_below(found.angles[i], digits),
                                        detail::decimal_above(found.angles[i], digits)};
    });
  }

  /// Whether everything is known to the digits wanted.
  static bool enough(const std::vector<Arb>& radii, int digits) {
    Arb unit;
    arb_set_str(unit.get(), fmt::format("1e-{}", digits + kExtraDigits / 2).c_str(), 64);
    for (const Arb& radius : radii)
      if (!(unit - radius).positive()) return false;
    return true;
  }

  bool run(int digits) {
    long guard = kGuardBits;
    for (int attempt = 0; attempt < kTries; ++attempt, guard *= 2) {
      result.bits = static_cast<long>(std::ceil(digits * kBitsOfDigit)) + guard;
      std::vector<Arb> radii;
      if (!refine(result.bits)) return false;
      const Precision precision(result.bits);
      write_lengths(digits + kExtraDigits);
      if (!certify(digits, radii)) return false;
      if (!enough(radii, digits)) continue;
      write_rest(digits, radii);
      return result.reason.empty();
    }
    result.reason = "the precision was not enough for so many digits";
    return false;
  }
};

}  // namespace

Digits prove_digits(const Triangulation& triangulation, const Proof& proof, int digits,
                    const Context& context) {
  if (digits < 1 || digits > kMostDigits)
    throw InvalidInput(fmt::format("{} digits; there can be 1 to {}", digits, kMostDigits));
  DigitsRun run{triangulation, proof, context};
  if (!proof.proved || proof.claim != Proof::Claim::kMetric) {
    run.result.reason = proof.proved ? "there is no metric" : proof.reason;
  } else if (proof_text(proof).interval_newton) {
    run.result.reason =
        "many digits are for proofs by convexity, not with finite vertices or nearly flat "
        "tetrahedra";
  } else if (triangulation.edge_count() > kMostEdgesForDigits) {
    run.result.reason = fmt::format("many digits are for up to {} edge classes; here are {}",
                                    kMostEdgesForDigits, triangulation.edge_count());
  } else {
    run.result.proved = run.run(digits);
  }
  return std::move(run.result);
}

Proof prove_near(const Triangulation& triangulation, std::span<const double> lengths,
                 const ProveOptions& options, const Context& context) {
  constexpr long kPolishedBits = 128;
  Proof proof = prove(triangulation, lengths, options, context);
  DigitsRun run{triangulation, proof, context};
  if (proof.proved || proof.box.empty() || !options.flat.empty() ||
      run.metric.has_finite_vertex() || triangulation.edge_count() > kMostEdgesForDigits ||
      !run.refine(kPolishedBits))
    return proof;
  std::vector<double> polished;
  for (const Arb& length : run.x) polished.push_back(length.mid());
  Proof second = prove(triangulation, polished, options, context);
  return second.proved ? second : proof;
}

}  // namespace tripus::structure
