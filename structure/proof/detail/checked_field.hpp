#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include <flint/fmpq.h>
#include <flint/fmpq_poly.h>

#include "structure/proof/detail/arb_number.hpp"

/// Exact arithmetic for the checker of canonical decompositions: by no code of the prover, and
/// nothing is guessed.
namespace tripus::structure::detail {

/// A rational number.
class Rational {
 public:
  Rational() { fmpq_init(x_); }
  /// Reads "-12.75", exactly. Throws InvalidInput.
  explicit Rational(const std::string& decimal);
  Rational(const Rational& other) : Rational() { fmpq_set(x_, other.x_); }
  Rational& operator=(const Rational& other) {
    fmpq_set(x_, other.x_);
    return *this;
  }
  ~Rational() { fmpq_clear(x_); }
  fmpq* get() { return x_; }
  const fmpq* get() const { return x_; }

 private:
  fmpq_t x_;
};

/// A polynomial in x with rational coefficients.
class RationalPolynomial {
 public:
  RationalPolynomial() { fmpq_poly_init(p_); }
  explicit RationalPolynomial(long number) : RationalPolynomial() { fmpq_poly_set_si(p_, number); }
  /// Reads "1/2*x^2 - 3*x + 1/5". Throws InvalidInput.
  explicit RationalPolynomial(const std::string& text);
  RationalPolynomial(const RationalPolynomial& other) : RationalPolynomial() {
    fmpq_poly_set(p_, other.p_);
  }
  RationalPolynomial& operator=(const RationalPolynomial& other) {
    fmpq_poly_set(p_, other.p_);
    return *this;
  }
  ~RationalPolynomial() { fmpq_poly_clear(p_); }

  fmpq_poly_struct* get() { return p_; }
  const fmpq_poly_struct* get() const { return p_; }
  long degree() const { return fmpq_poly_degree(p_); }
  bool is_zero() const { return fmpq_poly_is_zero(p_) != 0; }
  /// Bits of its largest coefficient.
  long height() const;
  int sign_at(const Rational& x) const;
  Arb at(const Arb& x) const;

  friend bool operator==(const RationalPolynomial& a, const RationalPolynomial& b) {
    return fmpq_poly_equal(a.p_, b.p_) != 0;
  }

 private:
  fmpq_poly_t p_;
};

/// Q[x]/f with a root of f, and square roots of some of its members.
class CheckedField {
 public:
  /// The places of square roots: bits of a set.
  static constexpr std::size_t kMostRoots = 8;

  explicit CheckedField(RationalPolynomial f) : f_(std::move(f)) {}
  /// Encloses a root of f between two numbers, so narrowly that its width is below 2^-bits. False
  /// if f does not change its sign between them.
  bool find_root(Rational lower, Rational upper, long bits);
  /// p modulo f, at the root.
  Arb value(const RationalPolynomial& p) const { return reduced(p).at(root_); }
  RationalPolynomial reduced(const RationalPolynomial& p) const;
  /// Its inverse modulo f, if there is one.
  std::optional<RationalPolynomial> inverse(const RationalPolynomial& p) const;

  /// What square root number k is the root of.
  std::vector<RationalPolynomial> squares;

 private:
  RationalPolynomial f_;
  Arb root_;
};

/// A sum of members of Q[x]/f, each times a product of different square roots. Two such sums are
/// equal if they have the same terms.
class CheckedNumber {
 public:
  explicit CheckedNumber(const CheckedField& field) : field_(&field) {}
  /// p times the square roots whose bits are set.
  CheckedNumber(const CheckedField& field, const RationalPolynomial& p, unsigned roots = 0);

  bool is_zero() const { return terms_.empty(); }
  /// The term without square roots; the others.
  RationalPolynomial rational_part() const;
  /// Whether a term has square root number k.
  bool has_root(std::size_t k) const;
  /// At the root of f; of a number without square roots.
  Arb value() const { return field_->value(rational_part()); }

  friend CheckedNumber operator+(const CheckedNumber& a, const CheckedNumber& b);
  friend CheckedNumber operator-(const CheckedNumber& a);
  friend CheckedNumber operator*(const CheckedNumber& a, const CheckedNumber& b);
  friend CheckedNumber operator-(const CheckedNumber& a, const CheckedNumber& b) { return a + -b; }
  friend bool operator==(const CheckedNumber& a, const CheckedNumber& b) {
    return (a - b).is_zero();
  }

 private:
  void add(unsigned roots, const RationalPolynomial& p);
  const CheckedField* field_;
  std::map<unsigned, RationalPolynomial> terms_;  // none is 0
};

}  // namespace tripus::structure::detail
