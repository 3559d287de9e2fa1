#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tripus::topology {

/// The cone angle wanted around an edge class: the label of an edge. Exact where it is a rational
/// multiple of pi, which decides the kinds of the vertices at its ends and makes certificates
/// possible. The angle 2 pi says that the edge is not singular, 0 that it is parabolic: cut out of
/// the manifold, with a cusp in its place.
class ConeAngle {
 public:
  constexpr ConeAngle() = default;  ///< 2 pi

  /// The angle in radians. A double within 2 ulp of p/q pi, q <= 1000, stands for that number.
  /// Implicit, so that a list of doubles is a list of cone angles. Not checked: see
  /// `require_valid`.
  ConeAngle(double radians);

  /// numerator / denominator * pi; 0 <= numerator <= kLargestTerm, 0 < denominator <= kLargestTerm.
  static ConeAngle rational(std::int64_t numerator, std::int64_t denominator);

  double radians() const { return radians_; }
  bool is_rational() const { return denominator_ != 0; }
  /// In lowest terms, in units of pi; only where is_rational().
  std::int64_t numerator() const { return numerator_; }
  std::int64_t denominator() const { return denominator_; }
  bool is_parabolic() const { return radians_ == 0; }
  bool is_full() const { return numerator_ == 2 && denominator_ == 1; }
  /// 2 pi / the angle, 0 for a parabolic edge: what `parse_cone_order` reads, as short as it can be
  /// written.
  std::string order_text() const;

  friend bool operator==(const ConeAngle&, const ConeAngle&) = default;

  static constexpr std::int64_t kLargestTerm = 1'000'000'000;

 private:
  double radians_ = 0x1.921fb54442d18p+2;
  std::int64_t numerator_ = 2;
  std::int64_t denominator_ = 1;  // 0: not known to be rational
};

/// The label of a cone order, 2 pi / order: "1" for none, "2", "3", ..., fractions as "5/2" or
/// "2.5", and "0" for a parabolic edge.
/// Throws InvalidInput for anything else, also for negative orders and orders below 2 other than 0
/// and 1: a cone angle above pi is written as an angle, not as an order.
ConeAngle parse_cone_order(std::string_view text);

/// Whether every angle is 2 pi; also for an empty list, which stands for that.
bool all_full(std::span<const ConeAngle> cone_angles);

/// Whether two lists say the same of so many edge classes; an empty one stands for 2 pi everywhere.
bool same_angles(std::span<const ConeAngle> a, std::span<const ConeAngle> b,
                 std::size_t edge_count);

/// Cone angles [E] as every function takes them: an empty list becomes 2 pi everywhere.
/// Throws InvalidInput for a wrong number of angles, naming both, and for an angle that is negative
/// or not finite, naming its edge class.
std::vector<ConeAngle> completed(std::span<const ConeAngle> cone_angles, std::size_t edge_count);

}  // namespace tripus::topology
