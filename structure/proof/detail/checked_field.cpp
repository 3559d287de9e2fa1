#include "structure/proof/detail/checked_field.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <utility>

#include "base/error.hpp"

namespace tripus::structure::detail {
namespace {

constexpr long kMostDegree = 200;
constexpr std::size_t kMostDigits = 100000;

bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// What is left of a text as it is read.
class Reader {
 public:
  explicit Reader(const std::string& text) {
    for (const char c : text)
      if (c != ' ') rest_ += c;
  }
  bool at_end() const { return at_ == rest_.size(); }
  bool take(char c) {
    if (at_end() || rest_[at_] != c) return false;
    ++at_;
    return true;
  }
  /// Digits, perhaps none.
  std::string digits() {
    const std::size_t begin = at_;
    while (!at_end() && is_digit(rest_[at_])) ++at_;
    return rest_.substr(begin, at_ - begin);
  }

 private:
  std::string rest_;
  std::size_t at_ = 0;
};

[[noreturn]] void no_polynomial(const std::string& text) {
  throw InvalidInput("proof: " + quoted(text) +
                     " is no polynomial in x with rational coefficients, as 1/2*x^2 - 3*x + 5");
}

/// The next term, "3/2*x^2", after its sign; false if there is none.
bool read_term(Reader& reader, Rational& coefficient, long& power) {
  std::string number = reader.digits();
  fmpq_one(coefficient.get());
  power = 0;
  if (!number.empty()) {
    if (reader.take('/')) {
      const std::string below = reader.digits();
      if (below.find_first_not_of('0') == std::string::npos) return false;
      number += "/" + below;
    }
    if (fmpq_set_str(coefficient.get(), number.c_str(), 10) != 0) return false;
    fmpq_canonicalise(coefficient.get());
    if (!reader.take('*')) return true;
  }
  if (!reader.take('x')) return false;
  power = 1;
  if (!reader.take('^')) return true;
  const std::string exponent = reader.digits();
  const auto [end, code] =
      std::from_chars(exponent.data(), exponent.data() + exponent.size(), power);
  return code == std::errc() && power <= kMostDegree;
}

}  // namespace

// ---- rational numbers and polynomials -----------------------------------------------------------

Rational::Rational(const std::string& decimal) : Rational() {
  Reader reader(decimal);
  const bool negative = reader.take('-');
  std::string digits = reader.digits();
  std::string fraction = reader.take('.') ? reader.digits() : std::string();
  digits += fraction;
  if (digits.empty() || !reader.at_end() || digits.size() > kMostDigits)
    throw InvalidInput("proof: " + quoted(decimal) + " is no decimal number such as 0.25");
  const std::string text =
      (negative ? "-" : "") + digits + "/1" + std::string(fraction.size(), '0');
  fmpq_set_str(x_, text.c_str(), 10);
  fmpq_canonicalise(x_);
}

RationalPolynomial::RationalPolynomial(const std::string& text) : RationalPolynomial() {
  if (text.size() > kMostDigits) no_polynomial(text.substr(0, 40) + "...");
  Reader reader(text);
  Rational coefficient, before;
  for (bool first = true; first || !reader.at_end(); first = false) {
    const bool minus = reader.take('-');
    if (!minus && !reader.take('+') && !first) no_polynomial(text);
    long power = 0;
    if (!read_term(reader, coefficient, power)) no_polynomial(text);
    fmpq_poly_get_coeff_fmpq(before.get(), p_, power);
    if (minus)
      fmpq_sub(coefficient.get(), before.get(), coefficient.get());
    else
      fmpq_add(coefficient.get(), before.get(), coefficient.get());
    fmpq_poly_set_coeff_fmpq(p_, power, coefficient.get());
  }
}

long RationalPolynomial::height() const {
  long bits = static_cast<long>(fmpz_bits(fmpq_poly_denref(p_)));
  for (long k = 0; k <= degree(); ++k)
    bits = std::max(bits, static_cast<long>(fmpz_bits(fmpq_poly_numref(p_) + k)));
  return bits;
}

int RationalPolynomial::sign_at(const Rational& x) const {
  Rational y;
  fmpq_poly_evaluate_fmpq(y.get(), p_, x.get());
  return fmpq_sgn(y.get());
}

Arb RationalPolynomial::at(const Arb& x) const {
  Arb sum;
  Rational coefficient;
  for (long k = degree(); k >= 0; --k) {
    Arb term;
    fmpq_poly_get_coeff_fmpq(coefficient.get(), p_, k);
    arb_set_fmpq(term.get(), coefficient.get(), Precision::bits());
    sum = sum * x + term;
  }
  return sum;
}

// ---- the field ----------------------------------------------------------------------------------

bool CheckedField::find_root(Rational lower, Rational upper, long bits) {
  const int below = f_.sign_at(lower);
  if (below * f_.sign_at(upper) >= 0 || fmpq_cmp(lower.get(), upper.get()) >= 0) return false;
  Rational middle, width;
  const auto too_wide = [&] {
    fmpq_sub(width.get(), upper.get(), lower.get());
    const auto size = [](const fmpz* n) { return static_cast<long>(fmpz_bits(n)); };
    return fmpq_is_zero(width.get()) == 0 &&
           size(fmpq_numref(width.get())) - size(fmpq_denref(width.get())) >= -bits;
  };
  // Bisection in rational numbers.
  while (too_wide()) {
    fmpq_add(middle.get(), lower.get(), upper.get());
    fmpq_div_2exp(middle.get(), middle.get(), 1);
    const int sign = f_.sign_at(middle);
    if (sign != below) upper = middle;
    if (sign == below || sign == 0) lower = middle;
  }
  Arb end;
  arb_set_fmpq(root_.get(), lower.get(), Precision::bits());
  arb_set_fmpq(end.get(), upper.get(), Precision::bits());
  arb_union(root_.get(), root_.get(), end.get(), Precision::bits());
  return true;
}

RationalPolynomial CheckedField::reduced(const RationalPolynomial& p) const {
  RationalPolynomial result;
  fmpq_poly_rem(result.get(), p.get(), f_.get());
  return result;
}

std::optional<RationalPolynomial> CheckedField::inverse(const RationalPolynomial& p) const {
  if (reduced(p).is_zero()) return std::nullopt;
  RationalPolynomial common, factor, other;
  fmpq_poly_xgcd(common.get(), factor.get(), other.get(), p.get(), f_.get());
  if (fmpq_poly_is_one(common.get()) == 0) return std::nullopt;
  return factor;
}

// ---- numbers ------------------------------------------------------------------------------------

CheckedNumber::CheckedNumber(const CheckedField& field, const RationalPolynomial& p, unsigned roots)
    : field_(&field) {
  add(roots, p);
}

void CheckedNumber::add(unsigned roots, const RationalPolynomial& p) {
  RationalPolynomial& at = terms_[roots];
  fmpq_poly_add(at.get(), at.get(), field_->reduced(p).get());
  if (at.is_zero()) terms_.erase(roots);
}

RationalPolynomial CheckedNumber::rational_part() const {
  const auto found = terms_.find(0);
  return found == terms_.end() ? RationalPolynomial() : found->second;
}

bool CheckedNumber::has_root(std::size_t k) const {
  return std::ranges::any_of(terms_, [&](const auto& term) { return (term.first >> k & 1u) != 0; });
}

CheckedNumber operator+(const CheckedNumber& a, const CheckedNumber& b) {
  CheckedNumber result = a;
  for (const auto& [roots, p] : b.terms_) result.add(roots, p);
  return result;
}

CheckedNumber operator-(const CheckedNumber& a) {
  CheckedNumber result = a;
  for (auto& [roots, p] : result.terms_) fmpq_poly_neg(p.get(), p.get());
  return result;
}

CheckedNumber operator*(const CheckedNumber& a, const CheckedNumber& b) {
  CheckedNumber result(*a.field_);
  RationalPolynomial product;
  for (const auto& [one, p] : a.terms_)
    for (const auto& [two, q] : b.terms_) {
      fmpq_poly_mul(product.get(), p.get(), q.get());
      // A root that both have becomes its square.
      for (std::size_t k = 0; k < a.field_->squares.size(); ++k)
        if ((one & two & (1u << k)) != 0) {
          product = a.field_->reduced(product);
          fmpq_poly_mul(product.get(), product.get(), a.field_->squares[k].get());
        }
      result.add(one ^ two, product);
    }
  return result;
}

}  // namespace tripus::structure::detail
