// The checker of proofs. It shares nothing with the prover but the triangulation, the kinds of its
// vertices, the theorem and Arb.
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include <arb.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/detail/checked_convexity.hpp"
#include "structure/proof/detail/checked_finite.hpp"
#include "structure/proof/detail/checked_tetrahedron.hpp"
#include "structure/proof/proof_text.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using detail::CheckedGram;
using detail::Precision;
using detail::read_number;
using topology::Triangulation;

/// Bits beyond the digits that the proof has.
constexpr long kCheckGuard = 64;
constexpr long kMostCheckBits = 400000;
/// The box on which it is shown, so many radii but no less than a share of the length; and by what.
struct Attempt {
  double radii, share;
  bool by_newton;
};
/// The first that does counts. Nearly flat tetrahedra are true in small boxes only, and some of
/// them are not shown to be convex in any; where there are no cusps Newton's method then may do.
constexpr Attempt kAttempts[] = {
    {64, 0x1p-36, false}, {64, 0, false}, {2, 0, false}, {64, 0, true}};

long bits_for(const ProofText& proof) {
  std::size_t longest = 16;
  for (const std::string& text : proof.lengths) longest = std::max(longest, text.size());
  const double bits = 3.33 * static_cast<double>(longest) + kCheckGuard;
  if (bits > kMostCheckBits) throw InvalidInput("proof: its numbers have too many digits");
  return static_cast<long>(bits);
}

// ---- the whole ----------------------------------------------------------------------------------

std::string shown(const Arb& x) { return fmt::format("{:.6g}", x.mid()); }

struct Checker {
  const Triangulation& triangulation;
  const ProofText& proof;
  const Context& context;
  Attempt size;
  std::vector<topology::ConeAngle> cone_angles =
      topology::completed(proof.cone_angles, triangulation.edge_count());
  std::vector<topology::OrbifoldLink> links = topology::orbifold_links(triangulation, cone_angles);
  bool finite = false;    // whether a vertex is finite
  bool together = false;  // whether convexity is shown for all tetrahedra together
  detail::CheckedMatrix hessian{};
  std::vector<double> own_entry{};        // [E] sums of the diagonals of the Jacobians
  std::vector<Arb> x{}, radius{}, box{};  // [E]
  std::vector<Arb> K{}, weight{};         // [E]
  std::vector<int> straight{};            // [E]
  Arb volume{};
  std::string reason{};

  bool refuse(std::string why) {
    reason = std::move(why);
    return false;
  }

  /// 1, 0 or -1 on the diagonal of the Gram matrix.
  int kind(std::size_t t, int v) const {
    switch (links[triangulation.vertex_class(t, v)].kind) {
      case topology::VertexKind::kHyperideal:
        return 1;
      case topology::VertexKind::kIdeal:
        return 0;
      case topology::VertexKind::kFinite:
        return -1;
    }
    return 1;
  }
  /// An edge whose length may be any number: an end is ideal, or the ends are a point and a plane.
  bool has_any_sign(std::size_t e) const {
    const topology::EdgeCorner corner = triangulation.corners(e)[0];
    const auto& [a, b] = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
    return kind(corner.tetrahedron(), a) * kind(corner.tetrahedron(), b) != 1;
  }
  CheckedGram gram_of(std::size_t t, const std::vector<Arb>* around) const {
    return {lengths_of(t, around), {kind(t, 0), kind(t, 1), kind(t, 2), kind(t, 3)}};
  }
  Arb wanted_angle(std::size_t e) const {
    const topology::ConeAngle& k = cone_angles[e];
    if (!k.is_rational()) return Arb(k.radians());
    return (Arb(static_cast<double>(k.numerator())) / Arb(static_cast<double>(k.denominator()))) *
           number_pi(Arb());
  }

  std::array<Arb, 6> lengths_of(std::size_t t, const std::vector<Arb>* around) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      l[e] = around == nullptr ? x[edge] : x[edge].widened_by((*around)[edge]);
    }
    return l;
  }

  /// A cusp needs angles of an exact sum, which no doubles have.
  bool cusps_are_exact() {
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t)
      for (int e = 0; e < 6; ++e) {
        const std::size_t edge = triangulation.edge_class(t, e);
        if (cone_angles[edge].is_rational()) continue;
        for (const int v : topology::kEdgeEnds[static_cast<std::size_t>(e)])
          if (kind(t, v) == 0)
            return refuse(
                fmt::format("the cone angle of edge class {} is no fraction of pi: there is no "
                            "cusp at its end",
                            edge));
      }
    return true;
  }

  bool read() {
    if (!cusps_are_exact()) return false;
    const std::size_t count = triangulation.edge_count();
    if (proof.lengths.size() != count || proof.radii.size() != count)
      return refuse(fmt::format("{} lengths and {} radii for {} edge classes", proof.lengths.size(),
                                proof.radii.size(), count));
    for (std::size_t e = 0; e < count; ++e) {
      x.push_back(read_number(proof.lengths[e]));
      radius.push_back(read_number(proof.radii[e]));
      if (!arb_is_nonnegative(radius[e].get()))
        return refuse(fmt::format("the radius of edge class {} is not >= 0", e));
      if (cone_angles[e].is_parabolic()) {
        if (arb_is_zero(x[e].get()) == 0 || arb_is_zero(radius[e].get()) == 0)
          return refuse(fmt::format("edge class {} is parabolic, but its length is not 0", e));
        box.emplace_back();
        continue;
      }
      const bool any_sign = has_any_sign(e);
      const Arb share = any_sign ? Arb(size.share) : Arb(size.share) * x[e];
      const Arb some = Arb(size.radii) * radius[e];
      const bool held = finite && arb_is_zero(radius[e].get()) != 0;
      box.push_back(held ? Arb() : finite || !larger(share, some) ? some : share);
      if (!any_sign && !x[e].widened_by(box[e]).positive())
        return refuse(
            fmt::format("the length of edge class {} is not > 0 all around {}", e, shown(x[e])));
    }
    for (std::size_t e = 0; e < count; ++e) K.push_back(wanted_angle(e));
    weight.resize(count);
    straight.assign(count, 0);
    if (!std::is_sorted(proof.flat.begin(), proof.flat.end()) ||
        (!proof.flat.empty() && proof.flat.back() >= triangulation.tetrahedron_count()) ||
        proof.flat.empty() != (proof.claim == Proof::Claim::kMetric))
      return refuse("the flat tetrahedra do not fit to the claim");
    return true;
  }

  bool add_true(std::size_t t) {
    const CheckedGram around = gram_of(t, &box);
    if (!around.det.negative())
      return refuse(
          fmt::format("tetrahedron {}: det G < 0 fails, det G is near {}", t, shown(around.det)));
    if (!add_convexity(t, checked_jacobian(around)))
      return refuse(fmt::format("tetrahedron {}: its Jacobian is not shown to be > 0", t));
    const CheckedGram gram = gram_of(t, nullptr);
    const auto theta = checked_angles(gram);
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      K[edge] = K[edge] - theta[e];
    }
    if (proof.volume) volume = volume + checked_volume(gram, theta);
    return true;
  }

  /// Its weights, or its part of the Hessian.
  bool add_convexity(std::size_t t, const std::array<std::array<Arb, 6>, 6>& J) {
    const auto edge = [&](std::size_t e) {
      return triangulation.edge_class(t, static_cast<int>(e));
    };
    if (together) {
      for (std::size_t i = 0; i < 6; ++i)
        for (std::size_t j = 0; j < 6; ++j) {
          if (cone_angles[edge(i)].is_parabolic() || cone_angles[edge(j)].is_parabolic()) continue;
          Arb& entry = hessian[edge(i)][edge(j)];
          entry = entry + J[i][j];
          if (i == j) own_entry[edge(i)] += J[i][i].mid();
        }
      return true;
    }
    const auto weights = detail::checked_weights(J);
    for (std::size_t e = 0; weights && e < 6; ++e)
      weight[edge(e)] = weight[edge(e)] + Arb((*weights)[e]);
    return weights.has_value();
  }

  /// The weights of all together.
  bool find_weights() {
    // What a pin adds is of the size of the tetrahedra's own entries.
    std::vector<bool> out(x.size());
    for (std::size_t e = 0; e < x.size(); ++e)
      out[e] = cone_angles[e].is_parabolic() || hessian[e].empty();
    const auto pins =
        detail::checked_pins(triangulation, links, proof.flat.empty() ? std::vector<bool>() : out);
    if (std::ssize(pins) !=
        std::ranges::count(links, topology::VertexKind::kIdeal, &topology::OrbifoldLink::kind))
      return refuse("no edges outside flat tetrahedra hold the horospheres");
    for (const std::size_t e : pins) hessian[e][e] = hessian[e][e] + Arb(own_entry[e]);
    for (std::size_t e = 0; e < x.size(); ++e)
      if (out[e]) hessian[e][e] = Arb(1.0);
    const double share = detail::checked_share(hessian);
    if (!(share > 0)) return refuse("the Hessian is not shown to be > 0");
    for (std::size_t e = 0; e < x.size(); ++e)
      if (!out[e]) weight[e] = Arb(share * hessian[e][e].mid() * (1 - 0x1p-40));
    return true;
  }

  bool add_flat(std::size_t t) {
    const CheckedGram gram = gram_of(t, &box);
    if (!gram.det.positive())
      return refuse(
          fmt::format("tetrahedron {}: det G > 0 fails, det G is near {}", t, shown(gram.det)));
    for (int e = 0; e < 3; ++e) {
      if (!gram.cosine(e).negative()) continue;
      for (const int edge : {e, 5 - e}) {
        const std::size_t at = triangulation.edge_class(t, edge);
        K[at] = K[at] - number_pi(Arb());
        ++straight[at];
      }
      return true;
    }
    return refuse(fmt::format("tetrahedron {}: no angle pi is shown", t));
  }

  bool convexity() {
    Arb squares;
    for (std::size_t e = 0; e < x.size(); ++e) {
      if (weight[e].positive()) {
        squares = squares + square(K[e]) / weight[e].lower_end();
      } else if (!cone_angles[e].is_parabolic() &&
                 (straight[e] != 2 || !cone_angles[e].is_full())) {
        return refuse(fmt::format("edge class {}: its angles pi are {}, not 2", e, straight[e]));
      }
    }
    const Arb g = square_root(squares.upper_end());
    for (std::size_t e = 0; e < x.size(); ++e) {
      if (!weight[e].positive()) continue;
      const Arb bound = g / square_root(weight[e].lower_end());
      // <= the radius that is claimed, and < the box.
      if (!(box[e] - bound).positive() || !arb_le(bound.get(), radius[e].get()))
        return refuse(fmt::format(
            "edge class {}: its length is only shown to be within {} of {}, which is not <= {}", e,
            shown(bound), shown(x[e]), shown(radius[e])));
    }
    if (!proof.volume) return true;
    if (proof.claim == Proof::Claim::kFlat)
      return refuse("a flat minimiser has no claim to a volume");
    for (std::size_t e = 0; e < x.size(); ++e) volume = volume - 0.5 * (K[e] * x[e]);
    const Arb eighth = 0.125 * squares.upper_end();
    volume = (volume - eighth).widened_by(eighth);
    return within(volume, *proof.volume, "the volume");
  }

  bool within(const Arb& value, const DecimalInterval& claimed, const std::string& what) {
    const Arb lower = read_number(claimed.lower), upper = read_number(claimed.upper);
    if (arb_le(lower.get(), value.get()) && arb_le(value.get(), upper.get())) return true;
    return refuse(fmt::format("{}: {} (+- {:.2g}) is not shown to be from {} to {}", what,
                              shown(value), mag_get_d(arb_radref(value.get())),
                              quoted(claimed.lower), quoted(claimed.upper)));
  }

  bool angles() {
    if (proof.dihedral_angles.empty()) return true;
    if (proof.dihedral_angles.size() != triangulation.tetrahedron_count() || !proof.flat.empty())
      return refuse("the angles do not fit to the triangulation");
    for (std::size_t t = 0; t < proof.dihedral_angles.size(); ++t) {
      const auto theta = checked_angles(gram_of(t, &radius));
      for (std::size_t e = 0; e < 6; ++e)
        if (!within(theta[e], proof.dihedral_angles[t][e],
                    fmt::format("angle {} of tetrahedron {}", e, t)))
          return false;
    }
    return true;
  }

  /// With finite vertices: docs/theory.md 9.8.
  bool run_finite() {
    if (!read()) return false;
    if (!proof.flat.empty())
      return refuse("flat tetrahedra beside finite vertices are not checked");
    detail::FiniteClaim claim{triangulation, cone_angles, links, {}, {}, {}, K, box, radius};
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      if (context.stop_requested() || context.expired())
        return refuse("stopped before it was decided");
      const CheckedGram gram = gram_of(t, nullptr);
      claim.around.push_back(gram_of(t, &box));
      claim.within.push_back(gram_of(t, &radius));
      if (!claim.around[t].is_true() || !claim.within[t].is_true())
        return refuse(
            fmt::format("tetrahedron {}: det G < 0 or a minor < 0 fails, det G is near {}", t,
                        shown(gram.det)));
      const auto theta = checked_angles(gram), around = checked_angles(claim.within[t]);
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
        K[edge] = K[edge] - theta[e];
        claim.K_within[edge] = claim.K_within[edge] - around[e];
      }
      if (proof.volume) volume = volume + checked_volume(gram, theta);
    }
    claim.K = K;
    if (std::string why = detail::finite_refusal(claim); !why.empty())
      return refuse(std::move(why));
    if (!proof.volume) return angles();
    // Theory (110).
    for (std::size_t e = 0; e < x.size(); ++e)
      volume = (volume - 0.5 * (K[e] * x[e]))
                   .widened_by(0.5 * (claim.K_within[e].magnitude() * radius[e]));
    return within(volume, *proof.volume, "the volume") && angles();
  }

  bool run() {
    if (finite) return run_finite();
    if (!read()) return false;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      if (context.stop_requested() || context.expired())
        return refuse("stopped before it was decided");
      const bool flat = std::binary_search(proof.flat.begin(), proof.flat.end(), t);
      if (!(flat ? add_flat(t) : add_true(t))) return false;
    }
    return (!together || find_weights()) && convexity() && angles();
  }
};

bool has_kind(const std::vector<topology::OrbifoldLink>& links, topology::VertexKind kind) {
  return std::ranges::any_of(links, [&](const auto& link) { return link.kind == kind; });
}

ProofCheck check_by(const Attempt& attempt, const Triangulation& triangulation,
                    const ProofText& proof, const Context& context) {
  Checker checker{triangulation, proof, context, attempt};
  checker.finite = proof.interval_newton || attempt.by_newton ||
                   has_kind(checker.links, topology::VertexKind::kFinite);
  checker.together =
      has_kind(checker.links, topology::VertexKind::kIdeal) ||
      std::ranges::any_of(checker.cone_angles, [](const auto& k) { return k.is_parabolic(); });
  if (checker.together) {
    checker.hessian.resize(triangulation.edge_count());
    checker.own_entry.resize(triangulation.edge_count());
  }
  if (attempt.by_newton && (checker.together || !proof.flat.empty()))
    return {false, "Newton's method is of no use with cusps and flat tetrahedra"};
  const bool valid = checker.run();
  return {valid, valid ? std::string() : checker.reason};
}

}  // namespace

ProofCheck check_proof(const Triangulation& triangulation, const ProofText& proof,
                       const Context& context) {
  topology::require_solvable(triangulation, proof.cone_angles);
  if (!proof.proved) return {false, "nothing is claimed"};
  const Precision precision(bits_for(proof));
  ProofCheck first;
  for (const Attempt& attempt : kAttempts) {
    ProofCheck check = check_by(attempt, triangulation, proof, context);
    if (check || context.stop_requested() || context.expired()) return check;
    if (first.reason.empty()) first = std::move(check);
  }
  return first;
}

}  // namespace tripus::structure
