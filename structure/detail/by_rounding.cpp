#include <algorithm>
#include <cmath>
#include <cstdint>

#include "base/tolerances.hpp"
#include "structure/detail/existence_routes.hpp"

namespace tripus::structure::detail {
namespace {

using topology::Triangulation;

/// Common denominators tried in rounding, 1 to 16 and then doubling.
constexpr std::int64_t kLargestDenominator = std::int64_t{1} << 40;
std::int64_t next_denominator(std::int64_t q) { return q < 16 ? q + 1 : 2 * q; }

/// Nearest multiples of 1/q of the multipliers, scaled so that the largest is 1.
std::vector<std::array<Integer, 4>> rounded_multipliers(const std::vector<double>& w,
                                                        std::int64_t q) {
  const double largest = *std::max_element(w.begin(), w.end());
  std::vector<std::array<Integer, 4>> rounded(w.size() / 4);
  for (std::size_t v = 0; v < w.size(); ++v) {
    const double scaled = largest > 0 ? static_cast<double>(q) * std::max(0.0, w[v]) / largest : 0;
    rounded[v / 4][v % 4] = Integer(std::round(scaled));
  }
  return rounded;
}

/// Angles rounded to multiples of 1/q with all edge sums exactly 2: rounded down, then up by one
/// where the remainders are largest. Every angle moves by less than 1/q.
std::optional<StrictAngles> rounded_angles(const Triangulation& triangulation,
                                           const std::vector<double>& angles, std::int64_t q) {
  StrictAngles rounded;
  rounded.denominator = q;
  rounded.numerator.resize(triangulation.tetrahedron_count());
  std::vector<std::pair<double, topology::EdgeCorner>> remainders;
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    remainders.clear();
    std::int64_t missing = 2 * q;
    for (const auto corner : triangulation.corners(e)) {
      const std::size_t edge = static_cast<std::size_t>(corner.edge());
      const double scaled =
          static_cast<double>(q) * std::max(0.0, angles[6 * corner.tetrahedron() + edge]);
      const double down = std::floor(scaled);
      rounded.numerator[corner.tetrahedron()][edge] = Integer(down);
      missing -= static_cast<std::int64_t>(down);
      remainders.emplace_back(down - scaled, corner);
    }
    if (missing < 0 || missing > static_cast<std::int64_t>(remainders.size())) return std::nullopt;
    std::ranges::stable_sort(remainders, {}, [](const auto& r) { return r.first; });
    for (std::int64_t i = 0; i < missing; ++i) {
      const auto corner = remainders[static_cast<std::size_t>(i)].second;
      ++rounded.numerator[corner.tetrahedron()][static_cast<std::size_t>(corner.edge())];
    }
  }
  return rounded;
}

/// Where the margin is positive.
std::optional<Existence> strict_by_rounding(const Triangulation& triangulation,
                                            const AngleProgramme& programme) {
  const std::vector<double> angles = programme.angles();
  for (std::int64_t q = static_cast<std::int64_t>(std::ceil(1 / programme.margin()));
       q <= kLargestDenominator; q *= 2) {
    auto rounded = rounded_angles(triangulation, angles, q);
    if (rounded && check(triangulation, *rounded)) return *std::move(rounded);
  }
  return std::nullopt;
}

/// Where it is negative: R < 0 leaves room for rounding.
std::optional<Existence> none_by_rounding(const Triangulation& triangulation,
                                          const AngleProgramme& programme) {
  const std::vector<double> w = programme.vertex_multipliers();
  for (std::int64_t q = 1; q <= kLargestDenominator; q = next_denominator(q)) {
    auto found =
        certificate_from(triangulation, programme.constraints(), rounded_multipliers(w, q));
    if (found && found->kind == Certificate::Kind::kNone) return *std::move(found);
  }
  return std::nullopt;
}

/// Where it is 0 as far as rounding can tell. There is no room: both optima must be met.
std::optional<Existence> semi_by_rounding(const Triangulation& triangulation,
                                          const AngleProgramme& programme) {
  constexpr std::int64_t kLargest = 4096;
  const std::vector<double> w = programme.vertex_multipliers();
  std::optional<Certificate> certificate;
  for (std::int64_t q = 1; q <= kLargest && !certificate; q = next_denominator(q))
    certificate =
        certificate_from(triangulation, programme.constraints(), rounded_multipliers(w, q));
  if (!certificate || certificate->kind == Certificate::Kind::kNone) return certificate;
  const std::vector<double> angles = programme.angles();
  for (std::int64_t q = 1; q <= kLargest; q = next_denominator(q)) {
    const auto rounded = rounded_angles(triangulation, angles, q);
    if (rounded && is_angle_structure(triangulation, programme.constraints(), *rounded))
      return *std::move(certificate);
  }
  return std::nullopt;
}

}  // namespace

std::optional<Existence> by_rounding(const Triangulation& triangulation,
                                     const AngleProgramme& programme) {
  // Rounding keeps edge sums of 2 and makes no vertex sum exactly 1.
  if (!programme.constraints().plain) return std::nullopt;
  // The tolerance only chooses what is tried: a wrong guess finds nothing.
  if (programme.margin() > tolerance::kAngleMargin)
    return strict_by_rounding(triangulation, programme);
  if (programme.margin() < -tolerance::kAngleMargin)
    return none_by_rounding(triangulation, programme);
  return semi_by_rounding(triangulation, programme);
}

}  // namespace tripus::structure::detail
