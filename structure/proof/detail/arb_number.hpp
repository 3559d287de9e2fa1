#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include <acb.h>
#include <acb_hypgeom.h>
#include <arb.h>
#include <arb_mat.h>

/// Arb's balls with operators, as geometry/enclosure_formulae.hpp wants them. The precision of
/// every operation is that of the thread's latest `Precision`.

namespace tripus::structure::detail {

/// A matrix of Arb's balls, all 0 at first.
class ArbMatrix {
 public:
  ArbMatrix(std::size_t rows, std::size_t columns) {
    arb_mat_init(m_, static_cast<long>(rows), static_cast<long>(columns));
  }
  ~ArbMatrix() { arb_mat_clear(m_); }
  ArbMatrix(const ArbMatrix&) = delete;
  ArbMatrix& operator=(const ArbMatrix&) = delete;
  arb_mat_struct* get() { return m_; }
  arb_ptr at(std::size_t i, std::size_t j) {
    return arb_mat_entry(m_, static_cast<long>(i), static_cast<long>(j));
  }

 private:
  arb_mat_t m_;
};

class Precision {
 public:
  explicit Precision(long bits);
  ~Precision() { bits_ = before_; }
  Precision(const Precision&) = delete;
  Precision& operator=(const Precision&) = delete;
  static long bits() { return bits_; }

 private:
  static inline thread_local long bits_ = 64;
  long before_;
};

class Arb {
 public:
  Arb() { arb_init(x_); }
  explicit Arb(double exact) : Arb() { arb_set_d(x_, exact); }
  Arb(const Arb& other) : Arb() { arb_set(x_, other.x_); }
  Arb(Arb&& other) noexcept : Arb() { arb_swap(x_, other.x_); }
  Arb& operator=(const Arb& other) {
    arb_set(x_, other.x_);
    return *this;
  }
  Arb& operator=(Arb&& other) noexcept {
    arb_swap(x_, other.x_);
    return *this;
  }
  ~Arb() { arb_clear(x_); }

  arb_ptr get() { return x_; }
  arb_srcptr get() const { return x_; }

  /// The midpoint, to nearest; the greatest double below and the least above all members.
  double mid() const { return arf_get_d(arb_midref(x_), ARF_RND_NEAR); }
  double lower() const {
    arf_t bound;
    arf_init(bound);
    arb_get_lbound_arf(bound, x_, 64);
    const double result = arf_get_d(bound, ARF_RND_FLOOR);
    arf_clear(bound);
    return result;
  }
  double upper() const { return -(-*this).lower(); }
  bool positive() const { return arb_is_positive(x_) != 0; }
  bool negative() const { return arb_is_negative(x_) != 0; }
  bool finite() const { return arb_is_finite(x_) != 0; }
  /// Makes the ball wider by `radius` >= 0 on both sides.
  Arb widened(double radius) const {
    Arb result(*this);
    mag_t extra;
    mag_init(extra);
    mag_set_d(extra, radius);
    mag_add(arb_radref(result.x_), arb_radref(result.x_), extra);
    mag_clear(extra);
    return result;
  }
  /// The same by the upper end of another ball, which is >= 0.
  Arb widened_by(const Arb& radius) const {
    Arb result(*this);
    mag_t extra;
    mag_init(extra);
    arb_get_mag(extra, radius.x_);
    mag_add(arb_radref(result.x_), arb_radref(result.x_), extra);
    mag_clear(extra);
    return result;
  }
  /// An exact number that no member is below;
  Arb lower_end() const {
    Arb result;
    arb_get_lbound_arf(arb_midref(result.x_), x_, Precision::bits());
    return result;
  }
  /// one that no member is above, and one that no absolute value is above.
  Arb upper_end() const {
    Arb result;
    arb_get_ubound_arf(arb_midref(result.x_), x_, Precision::bits());
    return result;
  }
  Arb magnitude() const {
    Arb result;
    arb_get_abs_ubound_arf(arb_midref(result.x_), x_, Precision::bits());
    return result;
  }
  Arb midpoint() const {
    Arb result;
    arb_get_mid_arb(result.x_, x_);
    return result;
  }

  friend Arb operator+(const Arb& a, const Arb& b) { return apply(arb_add, a, b); }
  friend Arb operator-(const Arb& a, const Arb& b) { return apply(arb_sub, a, b); }
  friend Arb operator*(const Arb& a, const Arb& b) { return apply(arb_mul, a, b); }
  friend Arb operator/(const Arb& a, const Arb& b) { return apply(arb_div, a, b); }
  friend Arb operator*(double factor, const Arb& b) { return Arb(factor) * b; }
  friend Arb operator-(const Arb& a) {
    Arb result;
    arb_neg(result.x_, a.x_);
    return result;
  }
  friend Arb square(const Arb& a) { return apply(arb_sqr, a); }
  friend Arb square_root(const Arb& a) { return apply(arb_sqrt, a); }
  friend Arb angle_of(const Arb& y, const Arb& x) { return apply(arb_atan2, y, x); }
  friend Arb number_pi(const Arb&) {
    Arb result;
    arb_const_pi(result.x_, Precision::bits());
    return result;
  }
  friend Arb number_like(double value, const Arb&) { return Arb(value); }
  friend bool larger(const Arb& a, const Arb& b) {
    return arf_cmp(arb_midref(a.x_), arb_midref(b.x_)) > 0;
  }
  friend Arb select(bool mask, const Arb& a, const Arb& b) { return mask ? a : b; }

 private:
  template <class Function, class... Rest>
  static Arb apply(Function function, const Arb& a, const Rest&... rest) {
    Arb result;
    function(result.x_, a.x_, rest.x_..., Precision::bits());
    return result;
  }

  arb_t x_;
};

/// Clausen's function Im Li2(e^ix) of all members of x.
Arb clausen(const Arb& x);
/// The same of all |x| <= a: an interval about 0.
Arb clausen_near_zero(const Arb& a);

/// A number of a proof for its checker: binary, "0x1.3p-1", exactly, or decimal, "0.25e-3", within
/// Arb's rounding. Throws InvalidInput for anything else.
Arb read_number(const std::string& text);

/// The greatest decimal number with so many digits after the point that is at most every member of
/// x, and the least that is at least every member.
std::string decimal_below(const Arb& x, int digits);
std::string decimal_above(const Arb& x, int digits);
/// A decimal number near the midpoint.
std::string decimal_near(const Arb& x, int digits);
/// What decimal_near wrote, as an enclosure.
Arb from_decimal(const std::string& text);
/// An upper bound of x >= 0 as a whole number of units of the last digit, such as "3e-50".
std::string decimal_radius(const Arb& x, int digits);

}  // namespace tripus::structure::detail
