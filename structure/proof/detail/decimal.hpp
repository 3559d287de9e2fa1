#pragma once

#include <string>

#include "structure/proof/detail/arb_number.hpp"

namespace tripus::structure::detail {

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
