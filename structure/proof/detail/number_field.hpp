#pragma once

#include <memory>
#include <optional>
#include <string>

#include <flint/fmpq_poly.h>
#include <flint/fmpz_poly.h>

#include "structure/proof/detail/arb_number.hpp"

/// Numbers that are known exactly: polynomials with rational coefficients in one real root of an
/// integer polynomial f, reduced modulo f. What holds modulo f holds at every root of f, whether f
/// is irreducible or not.
namespace tripus::structure::detail {

/// The polynomial f.
class Modulus {
 public:
  explicit Modulus(const fmpz_poly_struct* f) {
    fmpq_poly_init(f_);
    fmpq_poly_set_fmpz_poly(f_, f);
  }
  ~Modulus() { fmpq_poly_clear(f_); }
  Modulus(const Modulus&) = delete;
  Modulus& operator=(const Modulus&) = delete;
  const fmpq_poly_struct* get() const { return f_; }
  long degree() const { return fmpq_poly_degree(f_); }

 private:
  fmpq_poly_t f_;
};

/// A member of Q[x]/f; without a modulus, a rational number.
class Algebraic {
 public:
  Algebraic() { fmpq_poly_init(p_); }
  explicit Algebraic(long number) : Algebraic() { fmpq_poly_set_si(p_, number); }
  Algebraic(const Algebraic& other) : Algebraic() { *this = other; }
  Algebraic& operator=(const Algebraic& other) {
    if (this != &other) fmpq_poly_set(p_, other.p_);
    modulus_ = other.modulus_;
    return *this;
  }
  Algebraic(Algebraic&& other) noexcept : Algebraic() { *this = std::move(other); }
  Algebraic& operator=(Algebraic&& other) noexcept {
    fmpq_poly_swap(p_, other.p_);
    modulus_.swap(other.modulus_);
    return *this;
  }
  ~Algebraic() { fmpq_poly_clear(p_); }

  bool is_zero() const { return fmpq_poly_is_zero(p_) != 0; }
  /// Its inverse modulo f, if it has one.
  std::optional<Algebraic> inverse() const;
  /// "1/2*x^2-3", x the root.
  std::string text() const;
  Arb at(const Arb& root) const;

  friend Algebraic operator+(const Algebraic& a, const Algebraic& b) {
    return combined(fmpq_poly_add, a, b);
  }
  friend Algebraic operator-(const Algebraic& a, const Algebraic& b) {
    return combined(fmpq_poly_sub, a, b);
  }
  friend Algebraic operator*(const Algebraic& a, const Algebraic& b) {
    Algebraic result = combined(fmpq_poly_mul, a, b);
    if (result.modulus_ && fmpq_poly_degree(result.p_) >= result.modulus_->degree())
      fmpq_poly_rem(result.p_, result.p_, result.modulus_->get());
    return result;
  }
  friend Algebraic operator-(const Algebraic& a) { return Algebraic() - a; }
  friend bool operator==(const Algebraic& a, const Algebraic& b) { return (a - b).is_zero(); }

 private:
  friend class NumberField;
  template <class Function>
  static Algebraic combined(Function function, const Algebraic& a, const Algebraic& b) {
    Algebraic result;
    function(result.p_, a.p_, b.p_);
    result.modulus_ = a.modulus_ ? a.modulus_ : b.modulus_;
    return result;
  }

  fmpq_poly_t p_;
  std::shared_ptr<const Modulus> modulus_;
};

/// f with an enclosure of one of its real roots. Numbers are guessed by lattice reduction (LLL)
/// from many digits; a guess proves nothing, and what is concluded has to be shown modulo f.
class NumberField {
 public:
  /// A polynomial f of at most this degree that seems to vanish at x, and has a root there.
  static std::optional<NumberField> guess(const Arb& x, int most_degree);

  long degree() const { return modulus_->degree(); }
  /// "x^2-3*x+1"
  std::string polynomial() const;
  const Arb& root() const { return root_; }

  /// A polynomial in the root that seems to be x. Source: docs/theory.md 9.7.
  std::optional<Algebraic> guess_member(const Arb& x) const;
  /// An enclosure of a number at the root.
  Arb value(const Algebraic& number) const { return number.at(root_); }
  /// The same to nearly all digits, for guesses: not an enclosure.
  Arb approximation(const Algebraic& number) const { return number.at(root_.midpoint()); }

 private:
  NumberField(std::shared_ptr<const Modulus> modulus, Arb root)
      : modulus_(std::move(modulus)), root_(std::move(root)) {}
  std::shared_ptr<const Modulus> modulus_;
  Arb root_;
};

}  // namespace tripus::structure::detail
