#include "structure/proof/detail/arb_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <functional>

#include <flint/fmpz.h>

#include "base/error.hpp"

namespace tripus::structure::detail {
namespace {

/// x less the multiple of 2 pi nearest to its midpoint.
Arb within_a_turn(const Arb& x) {
  const Arb turn = 2.0 * number_pi(x);
  Arb quotient = x / turn;
  fmpz_t turns;
  fmpz_init(turns);
  arf_get_fmpz(turns, arb_midref(quotient.get()), ARF_RND_NEAR);
  Arb count;
  arb_set_fmpz(count.get(), turns);
  fmpz_clear(turns);
  return x - count * turn;
}

}  // namespace

Precision::Precision(long bits) : before_(std::exchange(bits_, bits)) {
  // FLINT keeps memory for each thread, which nobody else gives back when the thread ends.
  struct Caches {
    Caches() = default;
    Caches(const Caches&) = delete;
    Caches& operator=(const Caches&) = delete;
    ~Caches() { flint_cleanup(); }
  };
  static thread_local const Caches kCaches;
  static_cast<void>(&kCaches);
}

Arb clausen_near_zero(const Arb& a) {
  // |Cl2(x)| <= |x| (1 - ln |x|) + |x|^3 / 60 < |x| (2 - ln |x|), which grows on |x| <= 1.
  mag_t size, bound;
  mag_init(size);
  mag_init(bound);
  arb_get_mag(size, a.get());
  if (mag_cmp_2exp_si(size, 0) > 0) {
    mag_inf(bound);
  } else if (mag_is_zero(size) == 0) {
    mag_neg_log(bound, size);
    mag_add_ui(bound, bound, 2);
    mag_mul(bound, bound, size);
  }
  Arb result;
  mag_set(arb_radref(result.get()), bound);
  mag_clear(size);
  mag_clear(bound);
  return result;
}

Arb clausen(const Arb& x) {
  const Arb reduced = within_a_turn(x);
  if (arb_contains_zero(reduced.get()) != 0) return clausen_near_zero(reduced);
  Arb result;
  acb_t z;
  acb_init(z);
  arb_sin_cos(acb_imagref(z), acb_realref(z), reduced.get(), Precision::bits());
  acb_hypgeom_dilog(z, z, Precision::bits());
  arb_set(result.get(), acb_imagref(z));
  acb_clear(z);
  return result;
}

namespace {

[[noreturn]] void unreadable(const std::string& text) {
  throw InvalidInput(
      "proof: " + quoted(text) +
      " is no number; write a decimal such as 0.25e-3, or a binary such as 0x1.3p-1");
}

}  // namespace

Arb read_number(const std::string& text) {
  Arb result;
  const bool negative = text.starts_with("-0x");
  if (negative || text.starts_with("0x")) {
    const std::size_t begin = negative ? 3 : 2;
    double value = 0;
    const auto [end, code] = std::from_chars(text.data() + begin, text.data() + text.size(), value,
                                             std::chars_format::hex);
    // More than 14 hexadecimal digits would have been rounded; a sign has been read.
    const std::size_t mantissa = std::min(text.find('p'), text.size());
    if (code != std::errc() || end != text.data() + text.size() || mantissa > begin + 15 ||
        std::signbit(value))
      unreadable(text);
    return Arb(negative ? -value : value);
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
