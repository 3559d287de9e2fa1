// The checker of proofs. It shares nothing with the prover but the triangulation, the theorem and
// Arb: determinants are expanded, angles are arc cosines, the Jacobian is that of theory (16),
// positive definiteness is Arb's Cholesky factorisation, and the volume is Ushijima's sum of
// dilogarithms.
#include <algorithm>
#include <array>
#include <charconv>

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <arb_mat.h>
#include <fmt/format.h>

#include "base/error.hpp"
#include "structure/proof/detail/arb_number.hpp"
#include "structure/proof/proof_text.hpp"
#include "topology/requirements.hpp"

namespace tripus::structure {
namespace {

using detail::Arb;
using detail::Precision;
using topology::Triangulation;

constexpr int kEnds[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
constexpr int kEdge[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};
/// Bits beyond the digits that the proof has.
constexpr long kCheckGuard = 64;
constexpr long kMostCheckBits = 400000;
/// The box on which convexity is shown: this many radii, but no less than a share of the length.
constexpr double kBoxRadii = 64;
constexpr double kBoxShare = 0x1p-36;

// ---- numbers as texts
// ----------------------------------------------------------------------------

[[noreturn]] void unreadable(const std::string& text) {
  throw InvalidInput(
      "proof: " + quoted(text) +
      " is no number; write a decimal such as 0.25e-3, or a binary such as 0x1.3p-1");
}

/// A decimal or binary number, exactly or, for a decimal one, within Arb's rounding.
Arb number_of(const std::string& text) {
  Arb result;
  if (text.starts_with("0x")) {
    double value = 0;
    const auto [end, code] =
        std::from_chars(text.data() + 2, text.data() + text.size(), value, std::chars_format::hex);
    // More than 14 hexadecimal digits would have been rounded.
    const std::size_t mantissa = std::min(text.find('p'), text.size());
    if (code != std::errc() || end != text.data() + text.size() || mantissa > 17) unreadable(text);
    return Arb(value);
  }
  const std::size_t exponent = text.find('e');
  const std::string digits = text.substr(0, exponent);
  const bool shaped = !digits.empty() &&
                      digits.find_first_not_of("0123456789.-") == std::string::npos &&
                      digits.find('-', 1) == std::string::npos &&
                      std::count(digits.begin(), digits.end(), '.') <= 1 &&
                      digits.find_first_of("0123456789") != std::string::npos;
  if (!shaped) unreadable(text);
  if (exponent != std::string::npos) {
    int power = 0;
    const char *begin = text.data() + exponent + 1, *end = text.data() + text.size();
    const auto [stop, code] = std::from_chars(*begin == '+' ? begin + 1 : begin, end, power);
    if (code != std::errc() || stop != end || std::abs(power) > 200000) unreadable(text);
  }
  if (arb_set_str(result.get(), text.c_str(), Precision::bits()) != 0) unreadable(text);
  return result;
}

long bits_for(const ProofText& proof) {
  std::size_t longest = 16;
  for (const std::string& text : proof.lengths) longest = std::max(longest, text.size());
  const double bits = 3.33 * static_cast<double>(longest) + kCheckGuard;
  if (bits > kMostCheckBits) throw InvalidInput("proof: its numbers have too many digits");
  return static_cast<long>(bits);
}

// ---- one tetrahedron
// -----------------------------------------------------------------------------

using Matrix4 = std::array<std::array<Arb, 4>, 4>;

Arb determinant3(const Matrix4& m, const std::array<int, 3>& rows,
                 const std::array<int, 3>& columns) {
  const auto at = [&](int i, int j) -> const Arb& {
    return m[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])]
            [static_cast<std::size_t>(columns[static_cast<std::size_t>(j)])];
  };
  return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
}

/// Gram matrix, cofactors and determinant of six lengths: theory (6).
struct CheckedGram {
  Matrix4 g, c;
  Arb det;

  explicit CheckedGram(const std::array<Arb, 6>& l) {
    for (std::size_t i = 0; i < 4; ++i) {
      g[i][i] = Arb(1.0);
      for (std::size_t j = 0; j < 4; ++j) {
        if (i == j) continue;
        arb_cosh(g[i][j].get(), l[static_cast<std::size_t>(kEdge[i][j])].get(), Precision::bits());
        g[i][j] = -g[i][j];
      }
    }
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) {
        const Arb minor = determinant3(g, without(i), without(j));
        c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
            (i + j) % 2 == 0 ? minor : -minor;
      }
    det = g[0][0] * c[0][0] + g[0][1] * c[0][1] + g[0][2] * c[0][2] + g[0][3] * c[0][3];
  }
  static std::array<int, 3> without(int i) {
    return {i == 0 ? 1 : 0, i <= 1 ? 2 : 1, i <= 2 ? 3 : 2};
  }
  /// cos theta_ij = c_kl / sqrt(c_kk c_ll), theory (10).
  Arb cosine(int e) const {
    const auto [k, l] = others(e);
    return c[k][l] / square_root(c[k][k] * c[l][l]);
  }
  static std::array<std::size_t, 2> others(int e) {
    return {static_cast<std::size_t>(kEnds[5 - e][0]), static_cast<std::size_t>(kEnds[5 - e][1])};
  }
};

std::array<Arb, 6> angles_of(const CheckedGram& gram) {
  std::array<Arb, 6> theta;
  for (int e = 0; e < 6; ++e)
    arb_acos(theta[static_cast<std::size_t>(e)].get(), gram.cosine(e).get(), Precision::bits());
  return theta;
}

/// d theta_ij / d l_ab by the general formula that follows theory (16).
Arb derivative(const CheckedGram& gram, const std::array<Arb, 6>& sinh, int angle, int length) {
  const auto& c = gram.c;
  const auto [k, l] = CheckedGram::others(angle);
  const auto a = static_cast<std::size_t>(kEnds[length][0]);
  const auto b = static_cast<std::size_t>(kEnds[length][1]);
  const Arb D = -gram.det;
  // p = -c_kk.
  const Arb bracket = c[k][a] * c[l][b] + c[k][b] * c[l][a] -
                      c[k][l] * (c[k][a] * c[k][b] / c[k][k] + c[l][a] * c[l][b] / c[l][l]);
  return sinh[static_cast<std::size_t>(length)] * bracket /
         (sinh[static_cast<std::size_t>(angle)] * D * square_root(D));
}

class CholeskyTest {
 public:
  CholeskyTest() {
    arb_mat_init(a_, 6, 6);
    arb_mat_init(l_, 6, 6);
  }
  ~CholeskyTest() {
    arb_mat_clear(a_);
    arb_mat_clear(l_);
  }
  CholeskyTest(const CholeskyTest&) = delete;
  CholeskyTest& operator=(const CholeskyTest&) = delete;

  /// Whether J - share diag(diagonal) is positive definite for every member of J.
  bool passes(const std::array<std::array<Arb, 6>, 6>& J, const std::array<double, 6>& diagonal,
              double share) {
    for (long i = 0; i < 6; ++i)
      for (long j = 0; j < 6; ++j) {
        const auto at = static_cast<std::size_t>(i);
        const Arb entry = i == j ? J[at][at] - Arb(share) * Arb(diagonal[at])
                                 : J[at][static_cast<std::size_t>(j)];
        arb_set(arb_mat_entry(a_, i, j), entry.get());
      }
    return arb_mat_cho(l_, a_, Precision::bits()) != 0;
  }

 private:
  arb_mat_t a_, l_;
};

/// Weights w with J >= diag(w) on the box; empty if none was shown.
std::optional<std::array<double, 6>> weights_on(const std::array<Arb, 6>& box,
                                                const CheckedGram& gram) {
  std::array<Arb, 6> sinh;
  for (std::size_t e = 0; e < 6; ++e) arb_sinh(sinh[e].get(), box[e].get(), Precision::bits());
  std::array<std::array<Arb, 6>, 6> J;
  std::array<double, 6> diagonal;
  for (int i = 0; i < 6; ++i) {
    const auto row = static_cast<std::size_t>(i);
    for (int j = i; j < 6; ++j)
      J[row][static_cast<std::size_t>(j)] = J[static_cast<std::size_t>(j)][row] =
          derivative(gram, sinh, i, j);
    diagonal[row] = J[row][row].mid();
  }
  CholeskyTest test;
  double shown = 0, failed = 1;
  for (int halving = 0; halving < 40 && (shown == 0 || failed > 1.02 * shown); ++halving) {
    const double share = shown == 0 ? failed / 2 : (shown + failed) / 2;
    (test.passes(J, diagonal, share) ? shown : failed) = share;
  }
  if (shown == 0) return std::nullopt;
  for (double& entry : diagonal) entry *= shown * (1 - 0x1p-40);
  return diagonal;
}

/// Ushijima's formula, theory (24), as it stands.
class VolumeFormula {
 public:
  VolumeFormula(const CheckedGram& gram, const std::array<Arb, 6>& theta) {
    for (auto& value : v_) acb_init(&value);
    for (std::size_t e = 0; e < 6; ++e) {
      arb_sin_cos(acb_imagref(unit(kOrder[e])), acb_realref(unit(kOrder[e])), theta[e].get(),
                  bits());
      arb_set(sine_[kOrder[e]].get(), acb_imagref(unit(kOrder[e])));
    }
    // -det g = D^3 / prod(-c_ii).
    const Arb D = -gram.det;
    const auto& c = gram.c;
    root_ = square_root(D * D * D / (c[0][0] * c[1][1] * c[2][2] * c[3][3]));
  }
  ~VolumeFormula() {
    for (auto& value : v_) acb_clear(&value);
  }
  VolumeFormula(const VolumeFormula&) = delete;
  VolumeFormula& operator=(const VolumeFormula&) = delete;

  Arb volume() { return 0.25 * (sum_at(-1) - sum_at(1)); }

 private:
  // a, b, c, d, e, f by the edges 01, 02, 03, 12, 13, 23: d is opposite a, e opposite b.
  static constexpr std::size_t kOrder[6] = {0, 1, 2, 5, 4, 3};
  static long bits() { return Precision::bits(); }
  acb_ptr unit(std::size_t letter) { return &v_[letter]; }

  /// `to` = the product of some of the letters.
  void product(acb_ptr to, std::string_view letters) {
    acb_one(to);
    for (const char letter : letters) acb_mul(to, to, unit(std::size_t(letter - 'a')), bits());
  }

  /// z with the sign of the root, theory (24).
  void find_z(int sign) {
    acb_ptr z = &v_[6], term = &v_[7];
    acb_zero(z);
    for (const char* letters : {"ad", "be", "cf", "abf", "ace", "bcd", "def", "abcdef"}) {
      product(term, letters);
      acb_add(z, z, term, bits());
    }
    const Arb sum = sine_[0] * sine_[3] + sine_[1] * sine_[4] + sine_[2] * sine_[5];
    arb_mul_si(acb_realref(term), sum.get(), -2, bits());
    arb_mul_si(acb_imagref(term), root_.get(), -2 * sign, bits());
    acb_div(z, term, z, bits());
  }

  /// Im of the sum of the dilogarithms.
  Arb sum_at(int sign) {
    find_z(sign);
    acb_ptr z = &v_[6], term = &v_[7];
    Arb sum;
    for (const char* letters : {"", "abde", "acdf", "bcef"}) {
      product(term, letters);
      acb_mul(term, term, z, bits());
      acb_hypgeom_dilog(term, term, bits());
      arb_add(sum.get(), sum.get(), acb_imagref(term), bits());
    }
    for (const char* letters : {"abc", "aef", "bdf", "cde"}) {
      product(term, letters);
      acb_mul(term, term, z, bits());
      acb_neg(term, term);
      acb_hypgeom_dilog(term, term, bits());
      arb_sub(sum.get(), sum.get(), acb_imagref(term), bits());
    }
    return sum;
  }

  std::array<acb_struct, 8> v_;
  std::array<Arb, 6> sine_;
  Arb root_;
};

// ---- the whole ----------------------------------------------------------------------------------

std::string shown(const Arb& x) { return fmt::format("{:.6g}", x.mid()); }

struct Checker {
  const Triangulation& triangulation;
  const ProofText& proof;
  const Context& context;
  std::vector<Arb> x{}, radius{}, box{};  // [E]
  std::vector<Arb> K{}, weight{};         // [E]
  std::vector<int> straight{};            // [E]
  Arb volume{};
  std::string reason{};

  bool refuse(std::string why) {
    reason = std::move(why);
    return false;
  }

  std::array<Arb, 6> lengths_of(std::size_t t, const std::vector<Arb>* around) const {
    std::array<Arb, 6> l;
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      l[e] = around == nullptr ? x[edge] : x[edge].widened_by((*around)[edge]);
    }
    return l;
  }

  bool read() {
    const std::size_t count = triangulation.edge_count();
    if (proof.lengths.size() != count || proof.radii.size() != count)
      return refuse(fmt::format("{} lengths and {} radii for {} edge classes", proof.lengths.size(),
                                proof.radii.size(), count));
    for (std::size_t e = 0; e < count; ++e) {
      x.push_back(number_of(proof.lengths[e]));
      radius.push_back(number_of(proof.radii[e]));
      if (!arb_is_nonnegative(radius[e].get()))
        return refuse(fmt::format("the radius of edge class {} is not >= 0", e));
      const Arb share = Arb(kBoxShare) * x[e], some = Arb(kBoxRadii) * radius[e];
      box.push_back(larger(share, some) ? share : some);
      if (!x[e].widened_by(box[e]).positive())
        return refuse(
            fmt::format("the length of edge class {} is not > 0 all around {}", e, shown(x[e])));
    }
    K.assign(count, 2.0 * number_pi(Arb()));
    weight.resize(count);
    straight.assign(count, 0);
    if (!std::is_sorted(proof.flat.begin(), proof.flat.end()) ||
        (!proof.flat.empty() && proof.flat.back() >= triangulation.tetrahedron_count()) ||
        proof.flat.empty() != (proof.claim == Proof::Claim::kMetric))
      return refuse("the flat tetrahedra do not fit to the claim");
    return true;
  }

  bool add_true(std::size_t t) {
    const auto wide = lengths_of(t, &box);
    const CheckedGram around(wide);
    if (!around.det.negative())
      return refuse(
          fmt::format("tetrahedron {}: det G < 0 fails, det G is near {}", t, shown(around.det)));
    const auto weights = weights_on(wide, around);
    if (!weights)
      return refuse(fmt::format("tetrahedron {}: its Jacobian is not shown to be > 0", t));
    const CheckedGram gram(lengths_of(t, nullptr));
    const auto theta = angles_of(gram);
    for (std::size_t e = 0; e < 6; ++e) {
      const std::size_t edge = triangulation.edge_class(t, static_cast<int>(e));
      K[edge] = K[edge] - theta[e];
      weight[edge] = weight[edge] + Arb((*weights)[e]);
    }
    if (proof.volume) volume = volume + VolumeFormula(gram, theta).volume();
    return true;
  }

  bool add_flat(std::size_t t) {
    const CheckedGram gram(lengths_of(t, &box));
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
      } else if (straight[e] != 2) {
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
    const Arb lower = number_of(claimed.lower), upper = number_of(claimed.upper);
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
      const auto theta = angles_of(CheckedGram(lengths_of(t, &radius)));
      for (std::size_t e = 0; e < 6; ++e)
        if (!within(theta[e], proof.dihedral_angles[t][e],
                    fmt::format("angle {} of tetrahedron {}", e, t)))
          return false;
    }
    return true;
  }

  bool run() {
    if (!read()) return false;
    for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
      if (context.stop_requested() || context.expired())
        return refuse("stopped before it was decided");
      const bool flat = std::binary_search(proof.flat.begin(), proof.flat.end(), t);
      if (!(flat ? add_flat(t) : add_true(t))) return false;
    }
    return convexity() && angles();
  }
};

}  // namespace

ProofCheck check_proof(const Triangulation& triangulation, const ProofText& proof,
                       const Context& context) {
  topology::require_geodesic_boundary(triangulation);
  if (!proof.proved) return {false, "nothing is claimed"};
  const Precision precision(bits_for(proof));
  Checker checker{triangulation, proof, context};
  const bool valid = checker.run();
  return {valid, valid ? std::string() : checker.reason};
}

}  // namespace tripus::structure
