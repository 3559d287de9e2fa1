#include "structure/proof/detail/number_field.hpp"

#include <cstdlib>
#include <utility>
#include <vector>

#include <flint/fmpz_lll.h>
#include <flint/fmpz_mat.h>
#include <flint/fmpz_poly_factor.h>

namespace tripus::structure::detail {
namespace {

/// Bits of the numbers that are not used: they absorb what rounding did to the last of them.
constexpr long kSpareBits = 32;
/// A relation among n numbers known to b bits is believed if its coefficients have fewer than this
/// share of b / n bits, as which they come out by chance.
constexpr double kShareOfBits = 0.75;

class IntegerMatrix {
 public:
  IntegerMatrix(std::size_t rows, std::size_t columns) {
    fmpz_mat_init(m_, static_cast<long>(rows), static_cast<long>(columns));
  }
  ~IntegerMatrix() { fmpz_mat_clear(m_); }
  IntegerMatrix(const IntegerMatrix&) = delete;
  IntegerMatrix& operator=(const IntegerMatrix&) = delete;
  fmpz_mat_struct* get() { return m_; }
  fmpz* at(std::size_t i, std::size_t j) {
    return fmpz_mat_entry(m_, static_cast<long>(i), static_cast<long>(j));
  }

 private:
  fmpz_mat_t m_;
};

class IntegerPolynomial {
 public:
  IntegerPolynomial() { fmpz_poly_init(p_); }
  ~IntegerPolynomial() { fmpz_poly_clear(p_); }
  IntegerPolynomial(const IntegerPolynomial&) = delete;
  IntegerPolynomial& operator=(const IntegerPolynomial&) = delete;
  fmpz_poly_struct* get() { return p_; }

 private:
  fmpz_poly_t p_;
};

/// The polynomial at x, by Horner's rule.
Arb evaluated(const fmpz_poly_struct* f, const Arb& x) {
  Arb sum;
  for (long k = fmpz_poly_degree(f); k >= 0; --k) {
    sum = sum * x;
    arb_add_fmpz(sum.get(), sum.get(), fmpz_poly_get_coeff_ptr(f, k), Precision::bits());
  }
  return sum;
}

/// Integers c, not all 0, with sum c_i x_i near 0, as coefficients of a polynomial; whether they
/// are too small for chance.
bool small_relation(const std::vector<Arb>& x, fmpz_poly_struct* relation) {
  const std::size_t n = x.size();
  const long bits = Precision::bits() - kSpareBits;
  IntegerMatrix lattice(n, n + 1);
  for (std::size_t i = 0; i < n; ++i) {
    fmpz_one(lattice.at(i, i));
    Arb scaled = x[i];
    arb_mul_2exp_si(scaled.get(), scaled.get(), bits);
    if (!scaled.finite()) return false;
    arf_get_fmpz(lattice.at(i, n), arb_midref(scaled.get()), ARF_RND_NEAR);
  }
  fmpz_lll_t method;
  fmpz_lll_context_init_default(method);
  fmpz_lll(lattice.get(), nullptr, method);
  fmpz_poly_zero(relation);
  flint_bitcnt_t largest = fmpz_bits(lattice.at(0, n));
  for (std::size_t i = 0; i < n; ++i) {
    fmpz_poly_set_coeff_fmpz(relation, static_cast<long>(i), lattice.at(0, i));
    largest = std::max(largest, fmpz_bits(lattice.at(0, i)));
  }
  return static_cast<double>(largest) <
         kShareOfBits * static_cast<double>(bits) / static_cast<double>(n);
}

std::vector<Arb> powers(const Arb& x, long count) {
  std::vector<Arb> result{Arb(1.0)};
  while (static_cast<long>(result.size()) < count) result.push_back(result.back() * x);
  return result;
}

/// The irreducible factor of f that vanishes near x, into f. False if there is none.
bool take_factor(IntegerPolynomial& f, const Arb& x) {
  fmpz_poly_factor_t factors;
  fmpz_poly_factor_init(factors);
  fmpz_poly_factor(factors, f.get());
  bool found = false;
  for (long k = 0; k < factors->num && !found; ++k) {
    found = arb_contains_zero(evaluated(factors->p + k, x).get()) != 0;
    if (found) fmpz_poly_set(f.get(), factors->p + k);
  }
  fmpz_poly_factor_clear(factors);
  return found;
}

}  // namespace

std::optional<Algebraic> Algebraic::inverse() const {
  Algebraic result;
  result.modulus_ = modulus_;
  if (is_zero()) return std::nullopt;
  if (!modulus_) {
    fmpq_poly_inv(result.p_, p_);
    return result;
  }
  Algebraic common, other;
  fmpq_poly_xgcd(common.p_, result.p_, other.p_, p_, modulus_->get());
  if (!fmpq_poly_is_one(common.p_)) return std::nullopt;
  return result;
}

std::string Algebraic::text() const {
  char* text = fmpq_poly_get_str_pretty(p_, "x");
  std::string result(text);
  flint_free(text);
  return result;
}

Arb Algebraic::at(const Arb& root) const {
  Arb sum;
  fmpz_t coefficient;
  fmpz_init(coefficient);
  for (long k = fmpq_poly_degree(p_); k >= 0; --k) {
    sum = sum * root;
    fmpz_set(coefficient, fmpq_poly_numref(p_) + k);
    arb_add_fmpz(sum.get(), sum.get(), coefficient, Precision::bits());
  }
  fmpz_clear(coefficient);
  arb_div_fmpz(sum.get(), sum.get(), fmpq_poly_denref(p_), Precision::bits());
  return sum;
}

std::optional<NumberField> NumberField::guess(const Arb& x, int most_degree) {
  IntegerPolynomial f;
  if (!small_relation(powers(x, most_degree + 1), f.get())) return std::nullopt;
  // x is known to nearly all bits; a ball about it in which f has a root is wider.
  Arb about = x.midpoint();
  mag_t radius;
  mag_init(radius);
  mag_set_ui_2exp_si(radius, 1, -(Precision::bits() - kSpareBits) / 2);
  arb_add_error_mag(about.get(), radius);
  mag_clear(radius);
  if (fmpz_poly_degree(f.get()) < 1 || !take_factor(f, about)) return std::nullopt;
  // A change of sign shows the root, between ends that are rounded outwards.
  const Arb left = about.lower_end(), right = about.upper_end();
  const Arb product = evaluated(f.get(), left) * evaluated(f.get(), right);
  if (!product.negative()) return std::nullopt;
  arb_union(about.get(), left.get(), right.get(), Precision::bits());
  return NumberField(std::make_shared<const Modulus>(f.get()), about);
}

std::string NumberField::polynomial() const {
  char* text = fmpq_poly_get_str_pretty(modulus_->get(), "x");
  std::string result(text);
  flint_free(text);
  return result;
}

std::optional<Algebraic> NumberField::guess_member(const Arb& x) const {
  std::vector<Arb> numbers = powers(root_.midpoint(), degree());
  numbers.push_back(x);
  IntegerPolynomial relation;
  if (!small_relation(numbers, relation.get())) return std::nullopt;
  const long n = degree();
  fmpz_t last;
  fmpz_init(last);
  fmpz_poly_get_coeff_fmpz(last, relation.get(), n);
  if (fmpz_is_zero(last)) {
    fmpz_clear(last);
    return std::nullopt;
  }
  fmpz_neg(last, last);
  fmpz_poly_truncate(relation.get(), n);
  Algebraic result;
  fmpq_poly_set_fmpz_poly(result.p_, relation.get());
  fmpq_poly_scalar_div_fmpz(result.p_, result.p_, last);
  result.modulus_ = modulus_;
  fmpz_clear(last);
  return result;
}

}  // namespace tripus::structure::detail
