#include "structure/existence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <optional>

#include "base/error.hpp"
#include "base/tolerances.hpp"
#include "structure/detail/angle_programme.hpp"
#include "structure/detail/rational_system.hpp"

// The programme of the widest margin m (docs/theory.md (50)) decides: m > 0, = 0 or < 0. Its primal
// optimum is the angle structure, its dual optimum the certificate, both with the same m. Three
// routes to exact numbers, each followed by an exact check, so that floating point only proposes:
//   1. round the floating-point optimum to a small common denominator;
//   2. solve the linear systems of its final basis over the rationals;
//   3. let the simplex method run over the rationals, and do 2 on its basis.

namespace tripus::structure {
namespace {

using detail::AngleProgramme;
using detail::Rational;
using topology::Triangulation;

/// Common denominators tried in rounding, 1 to 16 and then doubling.
constexpr std::int64_t kLargestDenominator = std::int64_t{1} << 40;
std::int64_t next_denominator(std::int64_t q) { return q < 16 ? q + 1 : 2 * q; }

/// A certificate from the vertex multipliers alone: given w, the largest u_e that (43) allows is
/// the minimum of w_v + w_v' around e, and it makes R smallest. Nothing if that R is not <= 0, or w
/// = 0.
std::optional<Certificate> certificate_from(const Triangulation& triangulation,
                                            std::vector<std::array<Integer, 4>> w) {
  Integer divisor = 0;
  for (const auto& four : w)
    for (const Integer& each : four) divisor = gcd(divisor, each);
  if (divisor == 0) return std::nullopt;
  Integer r = 0;
  for (auto& four : w) {
    for (Integer& each : four) {
      each /= divisor;
      r += each;
    }
  }
  Certificate certificate;
  certificate.edge.resize(triangulation.edge_count());
  for (std::size_t e = 0; e < certificate.edge.size(); ++e) {
    bool first = true;
    for (const auto corner : triangulation.corners(e)) {
      const auto& four = w[corner.tetrahedron()];
      const auto& ends = topology::kEdgeEnds[static_cast<std::size_t>(corner.edge())];
      const Integer sum =
          four[static_cast<std::size_t>(ends[0])] + four[static_cast<std::size_t>(ends[1])];
      if (first || sum < certificate.edge[e]) certificate.edge[e] = sum;
      first = false;
    }
    r -= 2 * certificate.edge[e];
  }
  if (r > 0) return std::nullopt;
  certificate.kind = r < 0 ? Certificate::Kind::kNone : Certificate::Kind::kSemi;
  certificate.vertex = std::move(w);
  return certificate;
}

/// Nearest multiples of 1/q of the multipliers, scaled so that the largest is 1.
std::vector<std::array<Integer, 4>> rounded_multipliers(const std::vector<double>& w,
                                                        std::int64_t q) {
  const double largest = *std::max_element(w.begin(), w.end());
  std::vector<std::array<Integer, 4>> rounded(w.size() / 4);
  for (std::size_t v = 0; v < w.size(); ++v) {
    const double scaled = largest > 0 ? static_cast<double>(q) * std::max(0.0, w[v]) / largest : 0;
    rounded[v / 4][v % 4] = std::round(scaled);
  }
  return rounded;
}

/// Angles rounded to multiples of 1/q with all edge sums exactly 2: rounded down, then up by one
/// where the remainders are largest. Every angle moves by less than 1/q.
std::optional<StrictAngles> rounded_angles(const Triangulation& triangulation,
                                           const std::vector<double>& angles, std::int64_t q) {
  StrictAngles rounded;
  rounded.denominator = static_cast<long>(q);
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
      rounded.numerator[corner.tetrahedron()][edge] = down;
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

/// Exactly: angles >= 0, vertex sums <= 1, edge sums 2.
bool is_angle_structure(const Triangulation& triangulation, const StrictAngles& angles) {
  for (std::size_t t = 0; t < triangulation.tetrahedron_count(); ++t) {
    const auto& x = angles.numerator[t];
    if (std::ranges::any_of(x, [](const Integer& each) { return each < 0; })) return false;
    const Integer sums[] = {x[0] + x[1] + x[2], x[0] + x[3] + x[4], x[1] + x[3] + x[5],
                            x[2] + x[4] + x[5]};
    if (std::ranges::any_of(sums, [&](const Integer& sum) { return sum > angles.denominator; }))
      return false;
  }
  for (std::size_t e = 0; e < triangulation.edge_count(); ++e) {
    Integer sum = 0;
    for (const auto corner : triangulation.corners(e))
      sum += angles.numerator[corner.tetrahedron()][static_cast<std::size_t>(corner.edge())];
    if (sum != 2 * angles.denominator) return false;
  }
  return true;
}

/// Route 1 where the margin is positive.
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

/// Route 1 where it is negative: R < 0 leaves room for rounding.
std::optional<Existence> none_by_rounding(const Triangulation& triangulation,
                                          const AngleProgramme& programme) {
  const std::vector<double> w = programme.vertex_multipliers();
  for (std::int64_t q = 1; q <= kLargestDenominator; q = next_denominator(q)) {
    auto found = certificate_from(triangulation, rounded_multipliers(w, q));
    if (found && found->kind == Certificate::Kind::kNone) return *std::move(found);
  }
  return std::nullopt;
}

/// Route 1 where it is 0 as far as rounding can tell. There is no room: both optima must be met.
std::optional<Existence> semi_by_rounding(const Triangulation& triangulation,
                                          const AngleProgramme& programme) {
  constexpr std::int64_t kLargest = 4096;
  const std::vector<double> w = programme.vertex_multipliers();
  std::optional<Certificate> certificate;
  for (std::int64_t q = 1; q <= kLargest && !certificate; q = next_denominator(q))
    certificate = certificate_from(triangulation, rounded_multipliers(w, q));
  if (!certificate || certificate->kind == Certificate::Kind::kNone) return certificate;
  const std::vector<double> angles = programme.angles();
  for (std::int64_t q = 1; q <= kLargest; q = next_denominator(q)) {
    const auto rounded = rounded_angles(triangulation, angles, q);
    if (rounded && is_angle_structure(triangulation, *rounded)) return *std::move(certificate);
  }
  return std::nullopt;
}

std::optional<Existence> by_rounding(const Triangulation& triangulation,
                                     const AngleProgramme& programme) {
  if (programme.margin() > tolerance::kAngleMargin)
    return strict_by_rounding(triangulation, programme);
  if (programme.margin() < -tolerance::kAngleMargin)
    return none_by_rounding(triangulation, programme);
  return semi_by_rounding(triangulation, programme);
}

/// The basis as two square systems: the angles - m and m from the equations of the rows that hold
/// with equality, and the multipliers from those of the columns not at 0.
class BasisSystems {
 public:
  BasisSystems(const Triangulation& triangulation, const AngleProgramme::Basis& basis)
      : triangulation_(triangulation),
        basis_(basis),
        edge_count_(triangulation.edge_count()),
        corner_count_(6 * triangulation.tetrahedron_count()),
        row_place_(edge_count_ + 4 * triangulation.tetrahedron_count(), kAbsent),
        column_place_(corner_count_ + 1, kAbsent) {
    for (std::size_t i = 0; i < basis.rows.size(); ++i) row_place_[basis.rows[i]] = i;
    for (std::size_t i = 0; i < basis.columns.size(); ++i) column_place_[basis.columns[i]] = i;
  }

  /// [6 T + 1] angles - m, then m.
  std::optional<std::vector<Rational>> primal() const {
    detail::RationalSystem system = empty_system();
    for_each_coefficient([&](std::size_t row, std::size_t column, long a) {
      system.rows[row].emplace_back(column, a);
    });
    for (std::size_t i = 0; i < basis_.rows.size(); ++i)
      system.right_side[i] = basis_.rows[i] < edge_count_ ? 2 : 1;
    return spread(solve(system), basis_.columns, column_place_.size());
  }

  /// [E + 4 T] multipliers of the rows.
  std::optional<std::vector<Rational>> dual() const {
    detail::RationalSystem system = empty_system();
    for_each_coefficient([&](std::size_t row, std::size_t column, long a) {
      system.rows[column].emplace_back(row, a);
    });
    if (column_place_[corner_count_] == kAbsent) return std::nullopt;
    system.right_side[column_place_[corner_count_]] = 1;
    return spread(solve(system), basis_.rows, row_place_.size());
  }

 private:
  static constexpr std::size_t kAbsent = static_cast<std::size_t>(-1);

  detail::RationalSystem empty_system() const {
    const std::size_t size = basis_.rows.size();
    return {std::vector<std::vector<std::pair<std::size_t, long>>>(size),
            std::vector<Rational>(size)};
  }

  /// Calls visit(row place, column place, coefficient) for the entries of the square matrix.
  template <class Visit>
  void for_each_coefficient(const Visit& visit) const {
    const auto visit_if_there = [&](std::size_t row, std::size_t column, long a) {
      if (row_place_[row] != kAbsent && column_place_[column] != kAbsent)
        visit(row_place_[row], column_place_[column], a);
    };
    for (std::size_t e = 0; e < edge_count_; ++e)
      visit_if_there(e, corner_count_, static_cast<long>(triangulation_.valence(e)));
    for (std::size_t t = 0; t < triangulation_.tetrahedron_count(); ++t) {
      for (std::size_t v = 0; v < 4; ++v) visit_if_there(edge_count_ + 4 * t + v, corner_count_, 4);
      for (std::size_t e = 0; e < 6; ++e) {
        const std::size_t column = 6 * t + e;
        visit_if_there(triangulation_.edge_class(t, static_cast<int>(e)), column, 1);
        for (const int v : topology::kEdgeEnds[e])
          visit_if_there(edge_count_ + 4 * t + static_cast<std::size_t>(v), column, 1);
      }
    }
  }

  /// The values at their places among `size`, 0 elsewhere.
  static std::optional<std::vector<Rational>> spread(
      const std::optional<std::vector<Rational>>& values, const std::vector<std::size_t>& places,
      std::size_t size) {
    if (!values) return std::nullopt;
    std::vector<Rational> all(size);
    for (std::size_t i = 0; i < places.size(); ++i) all[places[i]] = (*values)[i];
    return all;
  }

  const Triangulation& triangulation_;
  const AngleProgramme::Basis& basis_;
  std::size_t edge_count_;
  std::size_t corner_count_;
  std::vector<std::size_t> row_place_;
  std::vector<std::size_t> column_place_;
};

Integer common_denominator(const std::vector<Rational>& values) {
  Integer denominator = 1;
  for (const Rational& value : values) denominator = lcm(denominator, value.get_den());
  return denominator;
}

StrictAngles exact_angles(const std::vector<Rational>& primal) {
  StrictAngles angles;
  angles.denominator = common_denominator(primal);
  angles.numerator.resize(primal.size() / 6);
  const Rational scaled_margin = primal.back() * angles.denominator;
  for (std::size_t c = 0; c + 1 < primal.size(); ++c) {
    const Rational angle = primal[c] * angles.denominator + scaled_margin;
    angles.numerator[c / 6][c % 6] = angle.get_num();
  }
  return angles;
}

/// The vertex multipliers [T x 4] as integers; nothing if one is negative.
std::optional<std::vector<std::array<Integer, 4>>> exact_multipliers(
    const std::vector<Rational>& dual, std::size_t edge_count) {
  const std::vector<Rational> w(dual.begin() + static_cast<std::ptrdiff_t>(edge_count), dual.end());
  if (std::ranges::any_of(w, [](const Rational& each) { return each < 0; })) return std::nullopt;
  const Integer denominator = common_denominator(w);
  std::vector<std::array<Integer, 4>> integers(w.size() / 4);
  for (std::size_t v = 0; v < w.size(); ++v)
    integers[v / 4][v % 4] = Rational(w[v] * denominator).get_num();
  return integers;
}

/// Route 2. Decides, or finds nothing if the basis is not optimal over the rationals.
std::optional<Existence> by_exact_basis(const Triangulation& triangulation,
                                        const AngleProgramme& programme) {
  const AngleProgramme::Basis basis = programme.basis();
  if (basis.rows.size() != basis.columns.size()) return std::nullopt;
  const BasisSystems systems(triangulation, basis);
  const auto primal = systems.primal();
  if (!primal) return std::nullopt;
  const StrictAngles angles = exact_angles(*primal);
  if (check(triangulation, angles)) return angles;
  const auto dual = systems.dual();
  if (!dual) return std::nullopt;
  auto w = exact_multipliers(*dual, triangulation.edge_count());
  if (!w) return std::nullopt;
  auto certificate = certificate_from(triangulation, *std::move(w));
  if (!certificate) return std::nullopt;
  if (certificate->kind == Certificate::Kind::kSemi && !is_angle_structure(triangulation, angles))
    return std::nullopt;
  return *std::move(certificate);
}

std::optional<Existence> search(const Triangulation& triangulation) {
  AngleProgramme programme(triangulation);
  std::optional<Existence> found;
  if (programme.solve()) {
    found = by_rounding(triangulation, programme);
    if (!found) found = by_exact_basis(triangulation, programme);
  }
  if (!found && programme.solve_exactly()) found = by_exact_basis(triangulation, programme);
  return found;
}

}  // namespace

Existence existence(const Triangulation& triangulation) {
  std::optional<Existence> found = search(triangulation);
  if (!found) throw InternalError("the existence of a strict angle structure could not be decided");
  const CheckResult result =
      std::visit([&](const auto& proof) { return check(triangulation, proof); }, *found);
  if (!result)
    throw InternalError("a proof about angle structures does not pass its check: " + result.reason);
  return *std::move(found);
}

}  // namespace tripus::structure
