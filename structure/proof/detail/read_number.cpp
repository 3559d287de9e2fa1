#include "structure/proof/detail/read_number.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"

namespace tripus::structure::detail {
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

}  // namespace tripus::structure::detail
