#pragma once

#include <cstdint>
#include <string>

#if defined(TRIPUS_WITHOUT_GMP)
#include <boost/multiprecision/cpp_int.hpp>
#else
#include <gmpxx.h>
#endif

// Whole and rational numbers of any size: GMP's, or Boost's where GMP is missing (a page's program
// of a browser). The rest of Tripus names neither. Beside arithmetic, comparison, abs, gcd and lcm
// there is what stands below. A fraction is made by division, which reduces it.

namespace tripus {

#if defined(TRIPUS_WITHOUT_GMP)

using BigInteger = boost::multiprecision::cpp_int;
using BigRational = boost::multiprecision::cpp_rational;

inline std::string to_decimal(const BigInteger& x) { return x.str(); }
/// Of decimal digits, perhaps with a minus sign.
inline BigInteger big_integer(const std::string& text) {
  const std::size_t first = text.find_first_of("123456789");  // after a 0 Boost reads octal digits
  if (first == std::string::npos) return 0;
  const BigInteger size(text.substr(first));
  return text[0] == '-' ? BigInteger(-size) : size;
}
inline BigInteger numerator_of(const BigRational& x) { return numerator(x); }
inline BigInteger denominator_of(const BigRational& x) { return denominator(x); }
inline double to_double(const BigRational& x) { return x.convert_to<double>(); }
inline int sign_of(const BigRational& x) { return x.sign(); }
/// A number that fits.
inline std::int64_t to_int64(const BigInteger& x) { return x.convert_to<std::int64_t>(); }
/// Of |x|; 0 for 0.
inline std::size_t binary_digits(const BigInteger& x) {
  return x == 0 ? 0 : static_cast<std::size_t>(msb(BigInteger(abs(x)))) + 1;
}

#else

using BigInteger = mpz_class;
using BigRational = mpq_class;

inline std::string to_decimal(const BigInteger& x) { return x.get_str(); }
/// Of decimal digits, perhaps with a minus sign.
inline BigInteger big_integer(const std::string& text) { return BigInteger(text, 10); }
inline BigInteger numerator_of(const BigRational& x) { return x.get_num(); }
inline BigInteger denominator_of(const BigRational& x) { return x.get_den(); }
inline double to_double(const BigRational& x) { return x.get_d(); }
inline int sign_of(const BigRational& x) { return sgn(x); }
/// A number that fits.
inline std::int64_t to_int64(const BigInteger& x) { return x.get_si(); }
/// Of |x|; 0 for 0.
inline std::size_t binary_digits(const BigInteger& x) {
  return x == 0 ? 0 : mpz_sizeinbase(x.get_mpz_t(), 2);
}

#endif

}  // namespace tripus
