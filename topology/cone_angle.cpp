#include "topology/cone_angle.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "topology/detail/text.hpp"

namespace tripus::topology {
namespace {

/// Denominators of pi up to here are recognised in a double. The doubles in [0, 2 pi] are 1e10
/// times as many as such fractions, so that none is met by accident.
constexpr std::int64_t kLargestRecognised = 1000;

struct Fraction {
  std::int64_t numerator;
  std::int64_t denominator;
};

/// A convergent of the continued fraction of x >= 0 that is within `error` of it.
std::optional<Fraction> recognised(double x, double error) {
  std::int64_t p0 = 1, q0 = 0, p1 = 0, q1 = 1;
  double rest = x;
  bool first = true;
  for (int term = 0; term < 20; ++term) {
    const double whole = std::floor(rest);
    if (!(whole < 1e6)) return std::nullopt;
    const auto a = static_cast<std::int64_t>(whole);
    const std::int64_t p = first ? a : a * p1 + p0, q = first ? 1 : a * q1 + q0;
    if (first) {
      p0 = 1;
      q0 = 0;
    } else {
      p0 = p1;
      q0 = q1;
    }
    first = false;
    p1 = p;
    q1 = q;
    if (q > kLargestRecognised) return std::nullopt;
    if (std::fabs(static_cast<double>(p) / static_cast<double>(q) - x) <= error)
      return Fraction{p, q};
    if (rest == whole) return std::nullopt;
    rest = 1 / (rest - whole);
  }
  return std::nullopt;
}

/// Decimal digits, nothing else, and few enough for kLargestTerm.
std::optional<std::int64_t> whole_number(std::string_view text) {
  if (text.empty() || text.size() > 9 || text.front() == '-') return std::nullopt;
  return detail::parse_integer(text);
}

/// "3", "5/2" or "2.5".
std::optional<Fraction> parse_fraction(std::string_view text) {
  if (const auto slash = text.find('/'); slash != std::string_view::npos) {
    const auto p = whole_number(text.substr(0, slash)), q = whole_number(text.substr(slash + 1));
    if (!p || !q || *q == 0) return std::nullopt;
    return Fraction{*p, *q};
  }
  std::string digits(text.substr(0, text.find('.')));
  std::int64_t scale = 1;
  if (const auto point = text.find('.'); point != std::string_view::npos) {
    std::string_view decimals = text.substr(point + 1);
    while (!decimals.empty() && decimals.back() == '0') decimals.remove_suffix(1);
    if (decimals.size() > 8) return std::nullopt;
    digits += decimals;
    for (std::size_t i = 0; i < decimals.size(); ++i) scale *= 10;
  }
  const auto p = whole_number(digits);
  if (!p) return std::nullopt;
  return Fraction{*p, scale};
}

}  // namespace

ConeAngle::ConeAngle(double radians) : radians_(radians), numerator_(0), denominator_(0) {
  if (!(radians >= 0) || !std::isfinite(radians)) return;
  const double x = radians / std::numbers::pi;
  const auto found = recognised(x, 2 * std::numeric_limits<double>::epsilon() * x);
  if (!found) return;
  numerator_ = found->numerator;
  denominator_ = found->denominator;
}

ConeAngle ConeAngle::rational(std::int64_t numerator, std::int64_t denominator) {
  const std::int64_t divisor = std::gcd(numerator, denominator);
  ConeAngle angle;
  angle.numerator_ = numerator / divisor;
  angle.denominator_ = denominator / divisor;
  angle.radians_ = static_cast<double>(angle.numerator_) * std::numbers::pi /
                   static_cast<double>(angle.denominator_);
  return angle;
}

std::string ConeAngle::order_text() const {
  if (is_parabolic()) return "0";
  if (!is_rational()) {
    std::string text = std::to_string(2 * std::numbers::pi / radians_);
    return text;
  }
  const std::int64_t p = 2 * denominator_, q = numerator_, divisor = std::gcd(p, q);
  std::string text = std::to_string(p / divisor);
  if (q != divisor) text += "/" + std::to_string(q / divisor);
  return text;
}

ConeAngle parse_cone_order(std::string_view text) {
  const auto order = parse_fraction(text);
  const bool none = order && order->numerator == order->denominator;
  const bool parabolic = order && order->numerator == 0;
  if (!order || !(none || parabolic || order->numerator >= 2 * order->denominator)) {
    throw InvalidInput(quoted(std::string(text)) +
                       " is not a cone order; write 1 (not singular), 2, 3, ..., a fraction above "
                       "2 such as 5/2, or 0 for a parabolic edge (other cone angles: as an angle, "
                       "such as 3pi/2)");
  }
  return parabolic ? ConeAngle::rational(0, 1)
                   : ConeAngle::rational(2 * order->denominator, order->numerator);
}

bool all_full(std::span<const ConeAngle> cone_angles) {
  return std::ranges::all_of(cone_angles, [](const ConeAngle& k) { return k.is_full(); });
}

bool same_angles(std::span<const ConeAngle> a, std::span<const ConeAngle> b,
                 std::size_t edge_count) {
  const auto fits = [&](std::span<const ConeAngle> list) {
    return list.empty() || list.size() == edge_count;
  };
  return fits(a) && fits(b) && completed(a, edge_count) == completed(b, edge_count);
}

std::vector<ConeAngle> completed(std::span<const ConeAngle> cone_angles, std::size_t edge_count) {
  if (cone_angles.empty()) return std::vector<ConeAngle>(edge_count);
  if (cone_angles.size() != edge_count) {
    throw InvalidInput("there are " + std::to_string(cone_angles.size()) + " cone angles for " +
                       std::to_string(edge_count) + " edge classes; give one for each");
  }
  for (std::size_t e = 0; e < edge_count; ++e) {
    const double k = cone_angles[e].radians();
    if (!std::isfinite(k) || k < 0) {
      throw InvalidInput("cone angle of edge class " + std::to_string(e) + " is " +
                         std::to_string(k) +
                         "; it must be finite and not negative (radians; 0 for a parabolic edge)");
    }
  }
  return {cone_angles.begin(), cone_angles.end()};
}

}  // namespace tripus::topology
