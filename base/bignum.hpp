#pragma once

/// Whole numbers and fractions of any size: GMP's, or Boost's in their place where GMP is not there
/// (TRIPUS_WITHOUT_GMP). With either, Integer has get_str, gcd and lcm, Rational has get_num and
/// get_den and is kept in lowest terms; the operators are those of numbers.

#ifdef TRIPUS_WITHOUT_GMP
#include "base/detail/boost_bignum.hpp"

namespace tripus {
using Integer = detail::BoostInteger;
using Rational = detail::BoostRational;
}  // namespace tripus
#else
#include <gmpxx.h>

namespace tripus {
using Integer = mpz_class;
using Rational = mpq_class;
}  // namespace tripus
#endif
