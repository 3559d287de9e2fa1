#include "structure/proof/detail/decimal.hpp"

#include <functional>

#include <flint/fmpz.h>

namespace tripus::structure::detail {
namespace {

/// An integer of FLINT.
class Integer {
 public:
  Integer() { fmpz_init(x_); }
  ~Integer() { fmpz_clear(x_); }
  Integer(const Integer&) = delete;
  Integer& operator=(const Integer&) = delete;
  fmpz* get() { return x_; }
  std::string text() const {
    char* digits = fmpz_get_str(nullptr, 10, x_);
    std::string result(digits);
    flint_free(digits);
    return result;
  }

 private:
  fmpz_t x_;
};

Arb scaled(const Arb& x, int digits) {
  Integer power;
  fmpz_ui_pow_ui(power.get(), 10, static_cast<unsigned long>(digits));
  Arb result;
  arb_mul_fmpz(result.get(), x.get(), power.get(), Precision::bits());
  return result;
}

/// An integer at most, at least, or near the members of x.
std::string integer_of(const Arb& x, arf_rnd_t rounding) {
  arf_t bound;
  arf_init(bound);
  if (rounding == ARF_RND_FLOOR)
    arb_get_lbound_arf(bound, x.get(), Precision::bits());
  else if (rounding == ARF_RND_CEIL)
    arb_get_ubound_arf(bound, x.get(), Precision::bits());
  else
    arf_set(bound, arb_midref(x.get()));
  Integer integer;
  arf_get_fmpz(integer.get(), bound, rounding);
  arf_clear(bound);
  return integer.text();
}

/// With the point before the last `digits` digits.
std::string with_point(std::string integer, int digits) {
  const bool negative = integer.front() == '-';
  if (negative) integer.erase(0, 1);
  const auto places = static_cast<std::size_t>(digits);
  if (integer.size() <= places) integer.insert(0, places + 1 - integer.size(), '0');
  integer.insert(integer.size() - places, ".");
  return (negative ? "-" : "") + integer;
}

}  // namespace

std::string decimal_below(const Arb& x, int digits) {
  return with_point(integer_of(scaled(x, digits), ARF_RND_FLOOR), digits);
}
std::string decimal_above(const Arb& x, int digits) {
  return with_point(integer_of(scaled(x, digits), ARF_RND_CEIL), digits);
}
std::string decimal_near(const Arb& x, int digits) {
  return with_point(integer_of(scaled(x, digits), ARF_RND_NEAR), digits);
}
Arb from_decimal(const std::string& text) {
  Arb result;
  arb_set_str(result.get(), text.c_str(), Precision::bits());
  return result;
}
std::string decimal_radius(const Arb& x, int digits) {
  return integer_of(scaled(x, digits), ARF_RND_CEIL) + "e-" + std::to_string(digits);
}

}  // namespace tripus::structure::detail
