#include "structure/proof/detail/checked_tetrahedron.hpp"

#include <string_view>
#include <utility>

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb_mat.h>

namespace tripus::structure::detail {
namespace {

constexpr int kEdge[4][4] = {{-1, 0, 1, 2}, {0, -1, 3, 4}, {1, 3, -1, 5}, {2, 4, 5, -1}};

Arb determinant3(const CheckedGram::Matrix4& m, const std::array<int, 3>& rows,
                 const std::array<int, 3>& columns) {
  const auto at = [&](int i, int j) -> const Arb& {
    return m[static_cast<std::size_t>(rows[static_cast<std::size_t>(i)])]
            [static_cast<std::size_t>(columns[static_cast<std::size_t>(j)])];
  };
  return at(0, 0) * (at(1, 1) * at(2, 2) - at(1, 2) * at(2, 1)) -
         at(0, 1) * (at(1, 0) * at(2, 2) - at(1, 2) * at(2, 0)) +
         at(0, 2) * (at(1, 0) * at(2, 1) - at(1, 1) * at(2, 0));
}

std::array<int, 3> without(int i) { return {i == 0 ? 1 : 0, i <= 1 ? 2 : 1, i <= 2 ? 3 : 2}; }

std::array<std::size_t, 2> others(int e) {
  return {static_cast<std::size_t>(kCheckedEnds[5 - e][0]),
          static_cast<std::size_t>(kCheckedEnds[5 - e][1])};
}

Arb derivative(const CheckedGram& gram, int angle, int length) {
  const auto& c = gram.c;
  const auto [k, l] = others(angle);
  const auto a = static_cast<std::size_t>(kCheckedEnds[length][0]);
  const auto b = static_cast<std::size_t>(kCheckedEnds[length][1]);
  const Arb D = -gram.det;
  // p = -c_kk.
  const Arb bracket = c[k][a] * c[l][b] + c[k][b] * c[l][a] -
                      c[k][l] * (c[k][a] * c[k][b] / c[k][k] + c[l][a] * c[l][b] / c[l][l]);
  return gram.slope[static_cast<std::size_t>(length)] * bracket /
         (gram.slope[static_cast<std::size_t>(angle)] * D * square_root(D));
}

/// Arb's Cholesky factorisation.
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

  /// Im Li2 of a number that has the absolute value 1, as those of (24) have. At an ideal vertex
  /// some are 1 itself, where Li2 has its branch point.
  static Arb dilogarithm(acb_ptr w) {
    Arb imaginary;
    if (acb_contains_int(w) != 0 && arb_is_positive(acb_realref(w)) != 0) {
      // The angle is at most pi/2 times the chord.
      acb_sub_ui(w, w, 1, bits());
      acb_abs(imaginary.get(), w, bits());
      return clausen_near_zero(2.0 * imaginary);
    }
    acb_hypgeom_dilog(w, w, bits());
    arb_set(imaginary.get(), acb_imagref(w));
    return imaginary;
  }

  /// Im of the sum of the dilogarithms.
  Arb sum_at(int sign) {
    find_z(sign);
    acb_ptr z = &v_[6], term = &v_[7];
    Arb sum;
    for (const char* letters : {"", "abde", "acdf", "bcef"}) {
      product(term, letters);
      acb_mul(term, term, z, bits());
      sum = sum + dilogarithm(term);
    }
    for (const char* letters : {"abc", "aef", "bdf", "cde"}) {
      product(term, letters);
      acb_mul(term, term, z, bits());
      acb_neg(term, term);
      sum = sum - dilogarithm(term);
    }
    return sum;
  }

  std::array<acb_struct, 8> v_;
  std::array<Arb, 6> sine_;
  Arb root_;
};

}  // namespace

CheckedGram::CheckedGram(const std::array<Arb, 6>& l, const std::array<int, 4>& kind) {
  for (std::size_t e = 0; e < 6; ++e) {
    const auto i = static_cast<std::size_t>(kCheckedEnds[e][0]);
    const auto j = static_cast<std::size_t>(kCheckedEnds[e][1]);
    Arb entry;
    if (kind[i] != 0 && kind[j] != 0) {
      arb_cosh(entry.get(), l[e].get(), Precision::bits());
      arb_sinh(slope[e].get(), l[e].get(), Precision::bits());
      if (kind[i] != kind[j]) std::swap(entry, slope[e]);
    } else {
      arb_exp(entry.get(), l[e].get(), Precision::bits());
      if (kind[i] == kind[j]) entry = 2.0 * entry;
      slope[e] = entry;
    }
    g[i][j] = g[j][i] = -entry;
  }
  for (std::size_t i = 0; i < 4; ++i) g[i][i] = Arb(kind[i]);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) {
      const Arb minor = determinant3(g, without(i), without(j));
      c[static_cast<std::size_t>(i)][static_cast<std::size_t>(j)] =
          (i + j) % 2 == 0 ? minor : -minor;
    }
  det = g[0][0] * c[0][0] + g[0][1] * c[0][1] + g[0][2] * c[0][2] + g[0][3] * c[0][3];
}

bool CheckedGram::is_true() const {
  return det.negative() && c[0][0].negative() && c[1][1].negative() && c[2][2].negative() &&
         c[3][3].negative();
}

Arb CheckedGram::cosine(int e) const {
  const auto [k, l] = others(e);
  return c[k][l] / square_root(c[k][k] * c[l][l]);
}

std::array<Arb, 6> checked_angles(const CheckedGram& gram) {
  std::array<Arb, 6> theta;
  for (std::size_t e = 0; e < 6; ++e) {
    // At a parabolic edge the angle is 0, where the arc cosine would lose half the digits.
    if (arb_is_zero(gram.slope[e].get()) != 0) continue;
    arb_acos(theta[e].get(), gram.cosine(static_cast<int>(e)).get(), Precision::bits());
  }
  return theta;
}

std::array<std::array<Arb, 6>, 6> checked_jacobian(const CheckedGram& gram) {
  std::array<std::array<Arb, 6>, 6> J;
  for (int i = 0; i < 6; ++i) {
    const auto row = static_cast<std::size_t>(i);
    if (arb_is_zero(gram.slope[row].get()) != 0) continue;
    for (int j = i; j < 6; ++j)
      J[row][static_cast<std::size_t>(j)] = J[static_cast<std::size_t>(j)][row] =
          derivative(gram, i, j);
  }
  return J;
}

std::optional<std::array<double, 6>> checked_weights(const std::array<std::array<Arb, 6>, 6>& J) {
  std::array<double, 6> diagonal;
  for (std::size_t i = 0; i < 6; ++i) diagonal[i] = J[i][i].mid();
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

Arb checked_volume(const CheckedGram& gram, const std::array<Arb, 6>& theta) {
  return VolumeFormula(gram, theta).volume();
}

}  // namespace tripus::structure::detail
